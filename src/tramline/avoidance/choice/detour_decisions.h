#pragma once
// The state of all decisions of one candidate while they are being made.

#include "tramline/avoidance/choice/decision.h"
#include "tramline/avoidance/choice/detour_pruning.h"
#include "tramline/avoidance/choose_detours.h"
#include "tramline/cost/worked/worked_ground.h"

namespace tramline {

/// All tracks that obstacles block, their options, and the detours chosen so far. Starts with every track cut
/// and our own ways allowed. Refers to the task.
class DetourDecisions {
 public:
  explicit DetourDecisions(const AvoidanceTask& task);
  /// Starts with the ways that were found, valued and chosen for the same task before.
  DetourDecisions(const AvoidanceTask& task, std::vector<Decision> found);

  /// Sets the ways to choose from. Present choices stay.
  void allow(WaysPast ways);
  WaysPast ways() const { return ways_; }
  /// Chooses Versleijen's way at every gap that has one. False where no gap has one. Precondition: these ways
  /// are allowed.
  bool choose_paper_ways();
  /// Chooses the detours that these tracks have.
  void choose_from(const std::vector<LaidTracks>& tracks);
  /// Gives every track the cheapest choice while the others stay, until none changes. False where nothing
  /// changed.
  bool improve();

  std::vector<LaidTracks> tracks() const;
  std::vector<Decision> decisions() && { return std::move(tracks_); }
  /// The decision at every gap, and the costs of the other allowed ways.
  std::vector<PlacedEncounter> encounters();

 private:
  const TrackFamily& family_of(const Decision& decision) const {
    return task_.families[decision.track.family];
  }
  const Track& track_of(const BlockedTrack& blocked) const {
    return task_.families[blocked.family].tracks[blocked.place];
  }
  const Track& track_of(const Decision& decision) const { return track_of(decision.track); }
  void prepare_families();
  void work(std::size_t family, std::size_t track, const std::vector<TrackDetour>& detours);
  void choose(Decision& decision, std::vector<TrackDetour> detours);
  void mark_stale_near(const Decision& decision, const std::vector<TrackDetour>& detours);

  // detour_options.cpp
  void add_tracks(std::size_t family);
  TrackTerms terms_of(const BlockedTrack& track) const;
  void add_options(BlockedTrack& track);
  void add_own_options(BlockedTrack& track, Passing side);
  void add_option(BlockedTrack& track, const WayRound& way);
  void add(BlockedTrack& track, const WayRound& way, Construction by);
  WayRound way_past_gaps(const BlockedTrack& track, std::size_t first, std::size_t last, Passing side) const;
  void add_versleijen_option(BlockedTrack& track, std::size_t gap);
  WayRound named(const BlockedTrack& track, WayRound way) const;
  std::vector<std::size_t> obstacles_in(const BlockedTrack& track, Interval gap) const;
  std::vector<std::size_t> obstacles_along(const BlockedTrack& track, const std::vector<std::size_t>& hazards,
                                           Interval range) const;
  std::vector<std::size_t> obstacles_near(const Track& curved, Interval range) const;
  void mark_expensive_options(Decision& decision);

  // detour_improvement.cpp
  void value(Decision& decision);
  double saving_of(Decision& decision, std::vector<TrackDetour>* best_detours);
  /// Tracks first to end − 1, blocked by one obstacle, whose choices are tried in combination.
  struct Group {
    std::size_t first = 0, end = 0;
    std::vector<std::vector<TrackDetour>> best;  ///< empty: nothing saves more than most_saved
    double most_saved = 0;
  };
  bool improve_groups();
  bool improve_group(std::size_t first, std::size_t end);
  void try_choices(Group& group, std::size_t at, double saved);

  // detour_encounters.cpp
  PlacedEncounter encounter_at(Decision& decision, std::size_t gap);
  std::vector<std::size_t> obstacles_passed_with(const Decision& decision, const TrackDetour& detour) const;

  const AvoidanceTask& task_;
  WaysPast ways_ = WaysPast::kOwn;
  double width_m_;
  double least_m_;
  std::vector<Surroundings> around_;  ///< by family
  std::vector<std::vector<Interval>>
      obstacles_;                        ///< by family of straight tracks and obstacle: its extent along
  std::vector<std::vector<Ring>> body_;  ///< its rings in the plane of each family
  WorkedGround ground_;
  std::vector<int> driven_;  ///< tracks with a piece, by family
  std::vector<Decision> tracks_;
};

}  // namespace tramline
