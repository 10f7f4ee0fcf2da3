#include "tramline/render/stops/stop_places.h"

#include <cstddef>

namespace tramline::render {
namespace {

/// A detour may begin and end anywhere, but does so along the line from start to end.
Point along(const TrackPiece& piece) {
  return (1 / distance(piece.start, piece.end)) * (piece.end - piece.start);
}

std::vector<StopPlace> ends_without_way_off(const std::vector<TrackPiece>& pieces) {
  std::vector<StopPlace> out;
  for (const TrackPiece& piece : pieces) {
    if (piece.start == piece.end) continue;
    const bool straight = piece.curve.empty();
    if (piece.stop_at_start)
      out.push_back({piece.start, straight ? along(piece) : direction_at_start(piece.curve.front())});
    if (piece.stop_at_end)
      out.push_back({piece.end, -1 * (straight ? along(piece) : direction_at_end(piece.curve.back()))});
  }
  return out;
}

}  // namespace

std::vector<StopPlace> stop_places(const Plan& plan) {
  if (!plan.route.planned()) return ends_without_way_off(plan.pieces);
  std::vector<StopPlace> out;
  const std::vector<RouteLeg>& legs = plan.route.legs;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].kind != LegKind::kBackOut || legs[i].path.empty()) continue;
    const bool out_of_end = i > 0 && legs[i - 1].work;
    const Pose begins = legs[i].path.front().start, ends = end_of(legs[i].path.back());
    if (out_of_end)
      out.push_back({begins.at, -1 * begins.heading.unit()});
    else
      out.push_back({ends.at, ends.heading.unit()});
  }
  return out;
}

}  // namespace tramline::render
