#include "tramline/route/order/lines.h"

#include <algorithm>
#include <utility>

namespace tramline::order {
namespace {

TrackPiece piece_backwards(TrackPiece piece) {
  std::swap(piece.start, piece.end);
  std::swap(piece.stop_at_start, piece.stop_at_end);
  piece.curve = reversed(piece.curve);
  std::reverse(piece.detours.begin(), piece.detours.end());
  for (Detour& detour : piece.detours) {
    detour.path = reversed(detour.path);
    detour.side = other_side(detour.side);
  }
  return piece;
}

}  // namespace

WorkedLine backwards(WorkedLine line) {
  std::reverse(line.begin(), line.end());
  for (std::size_t i = 0; i < line.size(); ++i) {
    line[i] = piece_backwards(std::move(line[i]));
    line[i].after_crossing = i > 0;
  }
  return line;
}

std::vector<WorkedLine> lines_of(const std::vector<TrackPiece>& pieces) {
  std::vector<WorkedLine> out;
  for (const TrackPiece& piece : pieces) {
    if (!piece.after_crossing) out.emplace_back();
    out.back().push_back(piece);
  }
  return out;
}

Tour backwards(const Tour& tour) {
  Tour out(tour.rbegin(), tour.rend());
  for (End& end : out) end = other_end(end);
  return out;
}

}  // namespace tramline::order
