#include "tramline/render/page/arrow_positions.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline::render {
namespace {

constexpr double kArrowSize = 9;
constexpr double kLeastArrow = 6;
// Chords this near to their arcs have the directions of the arcs as far as arrow heads can tell.
constexpr double kSagitta_m = 1e-3;

std::optional<Point> on_straight_part(const TrackPiece& piece, double room_m, const Box& seen) {
  const auto whole = clipped(piece.start, piece.end, seen);
  if (!whole) return std::nullopt;
  const Point middle = midpoint(whole->first, whole->second);
  std::optional<Point> best;
  for (const PathSegment& part : straight_parts(piece)) {
    const auto visible = clipped(part.from, part.to, seen);
    if (!visible) continue;
    const auto [from, to] = *visible;
    const double run = distance(from, to);
    if (run <= room_m) continue;
    const double margin = 0.5 * room_m / run;
    const double wanted = dot(middle - from, to - from) / (run * run);
    const double share = std::clamp(wanted, margin, 1 - margin);
    const Point place = share == wanted ? middle : from + share * (to - from);
    if (!best || distance(place, middle) < distance(*best, middle)) best = place;
  }
  return best;
}

std::optional<PointOnLine> on_curve(const Path& curve, double room_m, const Box& seen) {
  std::optional<PointOnLine> best;
  double longest = room_m;
  for (const std::vector<Point>& stretch : stretches_in(chords(curve, kSagitta_m), seen)) {
    const double run = length_of(stretch);
    if (run <= longest) continue;
    longest = run;
    best = point_along(stretch, 0.5 * run);
  }
  return best;
}

}  // namespace

std::optional<PointOnLine> arrow_position(const TrackPiece& piece, double room_m, const Box& seen) {
  assert(!piece.curve.empty() || piece.start != piece.end);
  if (!piece.curve.empty()) return on_curve(piece.curve, room_m, seen);
  const std::optional<Point> place = on_straight_part(piece, room_m, seen);
  if (!place) return std::nullopt;
  return PointOnLine{*place, (1 / distance(piece.start, piece.end)) * (piece.end - piece.start)};
}

std::vector<PointOnLine> arrow_positions_round(const Path& path, double room_m, double apart_m,
                                               const Box& seen) {
  std::vector<PointOnLine> out;
  for (const std::vector<Point>& stretch : stretches_in(chords(path, kSagitta_m), seen)) {
    const double run = length_of(stretch);
    if (run <= room_m) continue;
    const int count = std::max(1, static_cast<int>(run / apart_m));
    for (int i = 0; i < count; ++i) out.push_back(point_along(stretch, (i + 0.5) / count * run));
  }
  return out;
}

double arrow_size(double swath_px, double text_scale) {
  return std::clamp(0.7 * swath_px, kLeastArrow * text_scale, kArrowSize * text_scale);
}

// Odd, so that both headings of a boustrophedon get their share.
int arrow_stride(double swath_px, double arrow_px) {
  const int needed = static_cast<int>(std::ceil(1.2 * arrow_px / swath_px));
  return std::max(1, needed | 1);
}

}  // namespace tramline::render
