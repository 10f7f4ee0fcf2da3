#include "tramline/avoidance/detour/versleijen_detour.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/avoidance/detour/track_side.h"
#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Largest distance of the hazard's own outline to the side of a frame.
double farthest(const TurnedHazard& hazard, const DetourFrame& frame) {
  if (hazard.round) return frame.to_detour(hazard.round->centre).y + hazard.round->radius;
  return bounds(frame.to_detour(hazard.outline)).max_y;
}

/// Extent across the track.
double extent_across(const TurnedHazard& hazard, const TrackSide& track) {
  if (!track.curve) return hazard.box.width();
  return bounds(track.frame.to_detour(hazard.outline)).height();
}

/// The discs that the middle of the detour runs along, the least radius of a single one being `least`.
std::vector<KeepOut> buffer_of(const TurnedHazard& hazard, const DetourFrame& frame, double half_width,
                               double least) {
  if (hazard.round)
    return {{frame.to_detour(hazard.round->centre), std::max(hazard.round->radius + half_width, least)}};
  std::vector<KeepOut> out;
  for (const Point corner : hazard.outline) out.push_back({frame.to_detour(corner), half_width});
  return out;
}

/// The largest y of a segment. No arc is longer than half a circle, so it lies on the other side of its chord
/// than its centre: to the right of it where it turns left.
double top_of(const PathSegment& segment) {
  const double ends = std::max(segment.from.y, segment.to.y);
  if (segment.straight()) return ends;
  const Point top = centre(segment) + Point{0, radius(segment)};
  const bool on_arc = segment.curvature * cross(segment.to - segment.from, top - segment.from) <= 0;
  return on_arc ? top.y : ends;
}

/// Largest distance of the path from the track.
double peak_m(const Path& path, const TrackSide& track) {
  const Path aside = track.frame.to_detour(path);
  double out = 0;
  if (!track.curve) {
    for (const PathSegment& segment : aside) out = std::max(out, top_of(segment));
    return out;
  }
  for (const Point p : chords(aside)) {
    double off = std::numeric_limits<double>::infinity();
    for (const PathSegment& segment : track.curve->measured.path())
      off = std::min(off, distance_to_edge(segment, p, p));
    out = std::max(out, off);
  }
  return out;
}

/// The reason why the path, fitted into the track, is not to be driven.
Refusal fault_in_track(const Obstruction& o, const TrackDetour& detour, const TrackSide& track,
                       const VersleijenRule& rule, const Surroundings& around) {
  const Intervals& stretches = o.track.stretches;
  if (stretch_at(stretches, detour.from) != o.gap - 1 || stretch_at(stretches, detour.to) != o.gap)
    return Refusal::kVersleijenEndsBefore;
  const double width_m = o.grid.width_m, least = std::max(o.radius_m, 0.5 * width_m);
  if (rule.middle == DetourMiddle::kDrivable && smallest_radius(detour.path) < least * (1 - kRounding_share))
    return Refusal::kTooTight;
  if (std::isfinite(rule.room_m) && peak_m(detour.path, track) > rule.room_m + kSameDistance_m)
    return Refusal::kNoRoomBeside;
  const SwathLine line(detour.path, width_m);
  for (const TurnedHazard& hazard : around.hazards)
    if (runs_into(line, hazard)) return Refusal::kMeetsObstacle;
  return fault_of(line, around);
}

}  // namespace

WayRound versleijen_detour(const Obstruction& o, const VersleijenRule& rule, const Surroundings& around) {
  WayRound out;
  out.first_gap = out.last_gap = o.gap;
  const Interval gap{o.track.stretches[o.gap - 1].to, o.track.stretches[o.gap].from};
  out.hazards = hazards_in(o.grid, o.track, gap, around);
  const auto refuse = [&out](Refusal why) {
    out.why_not = why;
    return out;
  };
  if (out.hazards.size() != 1) return refuse(Refusal::kSeveralObstacles);
  const TurnedHazard& hazard = around.hazards[out.hazards.front()];
  const TrackSide to_the_left = track_side(o.grid, o.track, gap, Passing::kLeft);
  const TrackSide to_the_right = track_side(o.grid, o.track, gap, Passing::kRight);
  if (!(extent_across(hazard, to_the_left) < rule.threshold_m)) return refuse(Refusal::kTooWide);
  const bool drivable = rule.middle == DetourMiddle::kDrivable;

  const bool left = farthest(hazard, to_the_left.frame) <= farthest(hazard, to_the_right.frame);
  const TrackSide& track = left ? to_the_left : to_the_right;
  const double half = 0.5 * o.grid.width_m, radius = std::max(o.radius_m, half);
  std::optional<TrackDetour> found = detour_beside(
      track, buffer_of(hazard, track.frame, half, drivable ? radius : 0), radius, HullCorners::kAsTheyAre);
  out.detour.side = track.side;
  if (!found) return refuse(Refusal::kNoSide);
  out.detour = std::move(*found);
  return refuse(fault_in_track(o, out.detour, track, rule, around));
}

}  // namespace tramline
