#include "tramline/model/track.h"

#include <algorithm>
#include <cassert>

#include "tramline/geometry/path/kinked_line.h"

namespace tramline {
namespace {

/// A detour may begin where the piece does: what is left before it is no part.
constexpr double kDust = 1e-9;

}  // namespace

Path centre_line(const TrackPiece& piece) {
  assert(!piece.curve.empty() || piece.start != piece.end);
  if (!piece.curve.empty()) return piece.curve;
  Path out;
  Point at = piece.start;
  const auto drive_straight_to = [&](Point to) {
    if (distance(at, to) > kDust) out.push_back({at, to, 0});
  };
  for (const Detour& detour : piece.detours) {
    drive_straight_to(detour.path.front().from);
    out.insert(out.end(), detour.path.begin(), detour.path.end());
    at = detour.path.back().to;
  }
  drive_straight_to(piece.end);
  return out;
}

double length(const TrackPiece& piece) {
  if (piece.detours.empty() && piece.curve.empty()) return distance(piece.start, piece.end);
  return length(centre_line(piece));
}

Ring swath(const TrackPiece& piece, double width_m) {
  assert(!piece.curve.empty() || piece.start != piece.end);
  if (has_kinks(piece.curve)) return kinked_band(piece.curve, width_m);
  if (!piece.detours.empty() || !piece.curve.empty()) return band(centre_line(piece), width_m);
  const Point along = piece.end - piece.start;
  const double half = 0.5 * width_m / length(along);
  const Point right{half * along.y, -half * along.x};
  return {piece.start + right, piece.end + right, piece.end - right, piece.start - right};
}

std::vector<PathSegment> straight_parts(const TrackPiece& piece) {
  std::vector<PathSegment> out;
  Point at = piece.start;
  for (const Detour& detour : piece.detours) {
    out.push_back({at, detour.path.front().from, 0});
    at = detour.path.back().to;
  }
  out.push_back({at, piece.end, 0});
  std::erase_if(out, [](const PathSegment& part) { return distance(part.from, part.to) <= kDust; });
  return out;
}

std::vector<Path> parts_on_track(const TrackPiece& piece) {
  std::vector<Path> out;
  if (piece.curve.empty()) {
    for (const PathSegment& part : straight_parts(piece)) out.push_back({part});
    return out;
  }
  auto at = piece.curve.begin();
  for (const Detour& detour : piece.detours) {
    const auto first = std::find(at, piece.curve.end(), detour.path.front());
    if (first == piece.curve.end()) break;
    if (first != at) out.emplace_back(at, first);
    at = first + static_cast<std::ptrdiff_t>(detour.path.size());
  }
  if (at != piece.curve.end()) out.emplace_back(at, piece.curve.end());
  return out;
}

std::vector<Ring> swath_parts(const TrackPiece& piece, double width_m, double sagitta_m) {
  if (has_kinks(piece.curve)) return kinked_cells(piece.curve, width_m);
  if (!piece.curve.empty()) return {band(piece.curve, width_m, sagitta_m)};
  std::vector<Ring> out;
  for (const PathSegment& part : straight_parts(piece)) out.push_back(band({part}, width_m));
  for (const Detour& detour : piece.detours) out.push_back(band(detour.path, width_m, sagitta_m));
  return out;
}

}  // namespace tramline
