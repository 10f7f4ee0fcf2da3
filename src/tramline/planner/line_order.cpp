#include "tramline/planner/line_order.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tramline {
namespace {

WorkedLine backwards(const WorkedLine& line) {
  WorkedLine out(line.rbegin(), line.rend());
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::swap(out[i].start, out[i].end);
    std::swap(out[i].stop_at_start, out[i].stop_at_end);
    out[i].after_crossing = i > 0;
  }
  return out;
}

}  // namespace

void append_lines(const GapLines& lines, int subfield, std::vector<WorkedLine>& out) {
  int number = 0;
  for (const GapLine& line : lines.lines) {
    const double across = lines.grid.centre(line.pieces.front().strip);
    WorkedLine worked;
    for (const StripPiece& piece : line.pieces) {
      TrackPiece track;
      track.start = lines.grid.frame.to_field({across, piece.from});
      track.end = lines.grid.frame.to_field({across, piece.to});
      track.subfield = subfield;
      track.track = number;
      track.stop_at_start = piece.stop_at_from;
      track.stop_at_end = piece.stop_at_to;
      track.after_crossing = piece.after_crossing;
      worked.push_back(std::move(track));
    }
    out.push_back(std::move(worked));
    ++number;
  }
}

std::vector<TrackPiece> in_driving_order(std::vector<WorkedLine> lines) {
  std::vector<TrackPiece> out;
  while (!lines.empty()) {
    std::size_t next = 0;
    bool from_end = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < lines.size() && !out.empty(); ++i) {
      const double to_start = distance(out.back().end, lines[i].front().start);
      const double to_end = distance(out.back().end, lines[i].back().end);
      if (std::min(to_start, to_end) >= nearest) continue;
      nearest = std::min(to_start, to_end);
      next = i;
      from_end = to_end < to_start;
    }
    const WorkedLine line = from_end ? backwards(lines[next]) : lines[next];
    out.insert(out.end(), line.begin(), line.end());
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return out;
}

}  // namespace tramline
