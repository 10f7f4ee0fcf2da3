#include "tramline/avoidance/choice/detour_decisions.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tramline {
namespace {

TrackWork work_of(const Track& track, const std::vector<TrackDetour>& detours, double least_m) {
  LaidTracks out;
  append_pieces(track, detours, least_m, out);
  TrackWork work;
  for (const LaidPiece& piece : out.pieces) {
    for (const Interval& part : parts_on_track(piece)) work.on_track.push_back(part);
    for (const TrackDetour& detour : piece.detours) work.detours.push_back(detour);
  }
  return work;
}

/// The extents of the field's obstacles along a grid.
std::vector<Interval> extents_along(const Field& field, const TrackFrame& frame) {
  std::vector<Interval> out;
  for (const Obstacle& obstacle : field.obstacles) {
    const Box box = bounds(frame.to_track(obstacle.shape.outer));
    out.push_back({box.min_y, box.max_y});
  }
  return out;
}

/// The option that a detour was made from: a piece may hold it with positions beyond the length of a closed
/// track.
const TrackDetour& as_option(const BlockedTrack& track, const TrackDetour& detour) {
  for (const TrackOption& option : track.options)
    if (option.way.detour.path == detour.path) return option.way.detour;
  return detour;
}

}  // namespace

DetourDecisions::DetourDecisions(const AvoidanceTask& task) : DetourDecisions(task, {}) {
  for (std::size_t i = 0; i < task.families.size(); ++i) add_tracks(i);
  allow(WaysPast::kOwn);
}

DetourDecisions::DetourDecisions(const AvoidanceTask& task, std::vector<Decision> found)
    : task_(task),
      width_m_(task.machine.width_m),
      least_m_(min_length_m(task.machine)),
      ground_(task.families),
      driven_(task.families.size(), 0),
      tracks_(std::move(found)) {
  prepare_families();
  for (std::size_t i = 0; i < task.families.size(); ++i)
    for (std::size_t k = 0; k < task.families[i].tracks.size(); ++k) work(i, k, {});
  for (const Decision& decision : tracks_) work(decision.track.family, decision.track.place, decision.chosen);
}

/// Turns the surroundings, obstacles and body into the plane of each family.
void DetourDecisions::prepare_families() {
  for (const TrackFamily& family : task_.families) {
    around_.push_back(
        turned_surroundings(task_.ground, task_.field.outer, task_.settings.boundary, family.grid.frame));
    obstacles_.push_back(extents_along(task_.field, family.grid.frame));
    body_.emplace_back();
    for (const Ring& ring : rings_of(task_.ground.body))
      body_.back().push_back(family.grid.frame.to_track(ring));
  }
}

void DetourDecisions::allow(WaysPast ways) {
  ways_ = ways;
  for (Decision& decision : tracks_) tramline::allow(decision.track, ways);
}

void DetourDecisions::work(std::size_t family, std::size_t track, const std::vector<TrackDetour>& detours) {
  const bool was_driven = is_driven(ground_.at(family, track));
  ground_.set(family, track, work_of(task_.families[family].tracks[track], detours, least_m_));
  const int change = (is_driven(ground_.at(family, track)) ? 1 : 0) - (was_driven ? 1 : 0);
  driven_[family] += change;
  // When the number changes between none, one and two, another track may now be the only one.
  if (change == 0 || std::max(driven_[family], driven_[family] - change) > 2) return;
  for (Decision& decision : tracks_) decision.track.stale = true;
}

void DetourDecisions::choose(Decision& decision, std::vector<TrackDetour> detours) {
  if (same_detours(decision.chosen, detours)) return;
  mark_stale_near(decision, decision.chosen);
  mark_stale_near(decision, detours);
  decision.chosen = std::move(detours);
  work(decision.track.family, decision.track.place, decision.chosen);
}

/// The value of other tracks' options depends on where this track's detours are, and on the parts of its line
/// that they leave.
void DetourDecisions::mark_stale_near(const Decision& decision, const std::vector<TrackDetour>& detours) {
  const StripGrid& grid = family_of(decision).grid;
  const Track& track = track_of(decision);
  for (const TrackDetour& detour : detours) {
    Box changed = reach_of(detour.path, grid.width_m);
    changed.extend(swath_box(grid, track, {detour.from, detour.to}));
    // A short stretch may be driven only because the detour joins it to another.
    for (const Interval& stretch : track.stretches)
      if (stretch.length() < least_m_ && stretch.to >= detour.from && stretch.from <= detour.to)
        changed.extend(swath_box(grid, track, stretch));
    for (Decision& other : tracks_) {
      if (&other == &decision) continue;
      if (other.track.family == decision.track.family)
        mark_stale(other.track, family_of(other), changed);
      else
        mark_all_stale(other.track);
    }
  }
}

bool DetourDecisions::choose_paper_ways() {
  assert(ways_ == WaysPast::kPaper);
  bool any = false;
  for (Decision& decision : tracks_) {
    std::vector<TrackDetour> detours;
    for (const TrackOption& option : decision.track.options) {
      // Of two that run into each other on one track the first is driven: Versleijen says no more.
      if (!detours.empty() && detours.back().to > option.way.detour.from) continue;
      detours.push_back(option.way.detour);
    }
    any = any || !detours.empty();
    choose(decision, std::move(detours));
  }
  return any;
}

void DetourDecisions::choose_from(const std::vector<LaidTracks>& tracks) {
  for (Decision& decision : tracks_) {
    std::vector<TrackDetour> detours;
    const Track& track = track_of(decision);
    for (const LaidPiece& piece : tracks[decision.track.family].pieces)
      if (piece.track == track.index && piece.branch == track.branch)
        for (const TrackDetour& detour : piece.detours) detours.push_back(as_option(decision.track, detour));
    // Detours behind the beginning of a closed track come last in its piece.
    std::stable_sort(detours.begin(), detours.end(),
                     [](const TrackDetour& a, const TrackDetour& b) { return a.from < b.from; });
    choose(decision, std::move(detours));
  }
}

std::vector<LaidTracks> DetourDecisions::tracks() const {
  std::vector<LaidTracks> out;
  std::size_t next = 0;
  for (std::size_t i = 0; i < task_.families.size(); ++i) {
    const TrackFamily& family = task_.families[i];
    LaidTracks laid{family.grid, {}, {}};
    for (std::size_t k = 0; k < family.tracks.size(); ++k) {
      const bool decided =
          next < tracks_.size() && tracks_[next].track.family == i && tracks_[next].track.place == k;
      append_pieces(family.tracks[k], decided ? tracks_[next].chosen : std::vector<TrackDetour>{}, least_m_,
                    laid);
      if (decided) ++next;
    }
    out.push_back(std::move(laid));
  }
  return out;
}

}  // namespace tramline
