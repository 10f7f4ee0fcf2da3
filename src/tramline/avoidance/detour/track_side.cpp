#include "tramline/avoidance/detour/track_side.h"

#include <utility>

namespace tramline {

TrackSide track_side(const StripGrid& grid, const Track& track, Interval blocked, Passing side) {
  if (is_straight(track))
    return {grid.width_m, side, DetourFrame(grid.centre(track.index), side), std::nullopt};
  const PathPoint middle = MeasuredPath(track.path).at(0.5 * (blocked.from + blocked.to));
  const DetourFrame frame(middle.at, middle.heading, side);
  return {grid.width_m, side, frame,
          TrackLine{MeasuredPath(frame.to_detour(track.path)), blocked.from, blocked.to}};
}

Box reach_between(const TrackSide& track, Interval range) {
  const double half = 0.5 * track.width_m;
  if (!track.curve) return {range.from, -half, range.to, half};
  constexpr double kEvery_m = 1;
  const int looks = 1 + static_cast<int>(range.length() / kEvery_m);
  Box out;
  for (int i = 0; i <= looks; ++i) {
    const PathPoint on = track.curve->measured.at(range.from + range.length() * i / looks);
    const Point across = half * Point{-on.heading.y, on.heading.x};
    out.extend(on.at + across);
    out.extend(on.at - across);
  }
  return out;
}

std::optional<TrackDetour> detour_beside(const TrackSide& track, const std::vector<KeepOut>& discs,
                                         double radius_m, HullCorners corners) {
  std::optional<CurvedDetourPath> found;
  if (track.curve)
    found = curved_detour_path(discs, radius_m, *track.curve, corners);
  else if (std::optional<Path> path = detour_path(discs, radius_m, corners))
    found = CurvedDetourPath{*path, path->front().from.x, path->back().to.x};
  if (!found) return std::nullopt;
  TrackDetour out;
  out.side = track.side;
  out.path = track.frame.to_plane(found->path);
  out.from = found->from;
  out.to = found->to;
  out.length_m = length(out.path);
  return out;
}

}  // namespace tramline
