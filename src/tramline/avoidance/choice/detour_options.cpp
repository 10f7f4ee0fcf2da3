// The ways that each track has past what is in its way.

#include <algorithm>
#include <utility>

#include "tramline/avoidance/choice/detour_decisions.h"
#include "tramline/avoidance/detour/goes_round.h"
#include "tramline/avoidance/detour/versleijen_detour.h"
#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

Obstruction obstruction(const TrackFamily& family, const Track& track, std::size_t gap,
                        const Machine& machine) {
  return {family.grid, track, gap, machine.radius_m};
}

/// With Avoidance::kCheapest the paper's ways are drivable ones to choose from.
VersleijenRule versleijen_rule(const PlanSettings& settings, double width_m) {
  VersleijenRule out;
  out.threshold_m = settings.avoid_threshold_m < 0 ? width_m : settings.avoid_threshold_m;
  if (settings.avoid != Avoidance::kPaper) {
    out.middle = DetourMiddle::kDrivable;
    return out;
  }
  if (settings.avoid_room_m >= 0) out.room_m = settings.avoid_room_m;
  return out;
}

void refuse_gaps(BlockedTrack& track, const WayRound& way, Refusal why) {
  for (std::size_t gap = way.first_gap; gap <= way.last_gap; ++gap)
    track.refused.push_back({Construction::kOwn, gap, way.detour.side, why});
}

}  // namespace

void DetourDecisions::add_tracks(std::size_t family) {
  const std::vector<Track>& tracks = task_.families[family].tracks;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    BlockedTrack track;
    track.family = family;
    track.place = i;
    track.gaps = hard_gaps(tracks[i]);
    if (track.gaps.empty()) continue;
    track.correction_m2.assign(tracks[i].stretches.size(), 0);
    add_options(track);
    tracks_.push_back({std::move(track), {}});
    mark_expensive_options(tracks_.back());
  }
}

TrackTerms DetourDecisions::terms_of(const BlockedTrack& track) const {
  return {track.family, track_of(track), task_.objective, width_m_, least_m_};
}

/// Called while all tracks are cut.
void DetourDecisions::mark_expensive_options(Decision& decision) {
  BlockedTrack& track = decision.track;
  tramline::allow(track, WaysPast::kOwn);
  value(decision);
  for (TrackOption& option : track.options) {
    option.far_too_expensive = far_too_expensive(option, terms_of(track));
    if (option.far_too_expensive) refuse_gaps(track, option.way, Refusal::kFarTooExpensive);
  }
}

void DetourDecisions::add_options(BlockedTrack& track) {
  if (task_.settings.avoid != Avoidance::kPaper)
    for (const Passing side : {Passing::kLeft, Passing::kRight}) add_own_options(track, side);
  if (task_.settings.avoid != Avoidance::kCut)
    for (const std::size_t gap : track.gaps) add_versleijen_option(track, gap);
}

void DetourDecisions::add_own_options(BlockedTrack& track, Passing side) {
  std::vector<WayRound> alone;
  for (const std::size_t gap : track.gaps) {
    WayRound way = way_past_gaps(track, gap, gap, side);
    if (way.possible())
      alone.push_back(way);
    else
      track.refused.push_back({Construction::kOwn, gap, side, way.why_not});
    add_option(track, way);
  }
  for (const GapRow& row : rows_to_join(alone))
    add_option(track, way_past_gaps(track, row.first, row.last, side));
}

WayRound DetourDecisions::way_past_gaps(const BlockedTrack& track, std::size_t first, std::size_t last,
                                        Passing side) const {
  Obstruction gaps = obstruction(task_.families[track.family], track_of(track), first, task_.machine);
  gaps.last_gap = last;
  return way_round(gaps, side, around_[track.family]);
}

void DetourDecisions::add(BlockedTrack& track, const WayRound& way, Construction by) {
  TrackOption option = option_of(named(track, way), task_.families[track.family].grid, track_of(track));
  option.by = by;
  option.found = track.options.size();
  track.options.push_back(std::move(option));
}

/// Adds a way unless it is known, cannot be driven, or cannot pay.
void DetourDecisions::add_option(BlockedTrack& track, const WayRound& way) {
  if (!way.possible() || has_option(track, way)) return;
  add(track, way, Construction::kOwn);
  if (!can_be_pruned(track.options.back(), terms_of(track), task_.families, ground_)) return;
  track.options.pop_back();
  refuse_gaps(track, way, Refusal::kFarTooExpensive);
}

void DetourDecisions::add_versleijen_option(BlockedTrack& track, std::size_t gap) {
  const TrackFamily& family = task_.families[track.family];
  WayRound way = versleijen_detour(obstruction(family, track_of(track), gap, task_.machine),
                                   versleijen_rule(task_.settings, width_m_), around_[track.family]);
  if (!way.possible()) {
    for (const Passing side : {Passing::kLeft, Passing::kRight})
      track.refused.push_back({Construction::kPaper, gap, side, way.why_not});
    return;
  }
  const auto twin =
      std::find_if(track.options.begin(), track.options.end(), [&way](const TrackOption& option) {
        return option.by == Construction::kOwn && same_drive(option.way, way);
      });
  const bool has_twin = twin != track.options.end();
  if (has_twin) twin->has_twin = true;
  add(track, way, Construction::kPaper);
  track.options.back().has_twin = has_twin;
}

WayRound DetourDecisions::named(const BlockedTrack& track, WayRound way) const {
  way.detour.obstacles = obstacles_along(track, way.hazards, {way.detour.from, way.detour.to});
  if (!is_straight(track_of(track))) return way;
  const TrackFrame& frame = task_.families[track.family].grid.frame;
  std::erase_if(way.detour.obstacles, [&](std::size_t obstacle) {
    const Polygon& shape = task_.field.obstacles[obstacle].shape;
    return !goes_round(way.detour, frame.to_track(shape.outer));
  });
  return way;
}

/// The obstacles of the hazards that lie along the track there. Land given up may join a hazard's obstacles
/// to others far away, which are neither reached nor passed here.
std::vector<std::size_t> DetourDecisions::obstacles_along(const BlockedTrack& track,
                                                          const std::vector<std::size_t>& hazards,
                                                          Interval range) const {
  if (!is_straight(track_of(track))) return obstacles_near(track_of(track), range);
  std::vector<std::size_t> out;
  for (const std::size_t hazard : hazards)
    for (const std::size_t obstacle : task_.ground.hazards[hazard].obstacles) {
      const Interval extent = obstacles_[track.family][obstacle];
      if (extent.from < range.to - kSamePlace_m && extent.to > range.from + kSamePlace_m)
        out.push_back(obstacle);
    }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// The obstacles nearer to a curved track than its swath and the clearance.
std::vector<std::size_t> DetourDecisions::obstacles_near(const Track& curved, Interval range) const {
  const Path line = path_along(curved, range.from, range.to);
  const SwathLine reaching(line, width_m_ + 2 * task_.settings.clearance_m);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < task_.field.obstacles.size(); ++i) {
    const Obstacle& obstacle = task_.field.obstacles[i];
    if (obstacle.kind != ObstacleKind::kObstacle) continue;
    if (runs_into(reaching, {obstacle.shape.outer, bounds(obstacle.shape), {}})) out.push_back(i);
  }
  return out;
}

std::vector<std::size_t> DetourDecisions::obstacles_in(const BlockedTrack& track, Interval gap) const {
  const StripGrid& grid = task_.families[track.family].grid;
  return obstacles_along(track, hazards_in(grid, track_of(track), gap, around_[track.family]), gap);
}

}  // namespace tramline
