#pragma once
// The state of all decisions about one family of curved tracks while they are being made.

#include "tramline/avoidance/choose_curved_detours.h"
#include "tramline/avoidance/decision.h"
#include "tramline/cost/curved_cover.h"

namespace tramline {

/// The gaps of a track that hard land makes: between stretches gap − 1 and gap.
std::vector<std::size_t> hard_gaps(const Track& track);

/// All tracks that obstacles block, their options, and what is chosen so far. Starts with every track
/// cut. Refers to the task.
class CurvedDecisions {
 public:
  explicit CurvedDecisions(const CurvedAvoidanceTask& task);

  /// Chooses these detours, by track.
  void take(const std::vector<std::vector<TrackDetour>>& detours);
  /// Gives every track the choice that costs least while the others stay, until none changes. False
  /// where nothing changed.
  bool improve();

  std::vector<std::vector<TrackDetour>> detours() const;
  std::vector<CurvedEncounter> encounters();

 private:
  const Track& track_of(const Decision& decision) const { return task_.family.tracks[decision.track.strip]; }
  void add_options(BlockedTrack& blocked);
  void add_option(BlockedTrack& blocked, WayRound way);
  WayRound way_past_gaps(const Track& track, std::size_t first, std::size_t last, Passing side) const;
  std::vector<int> obstacles_near(const Track& track, Interval range) const;
  void work(std::size_t track, const std::vector<TrackDetour>& detours);
  void choose(Decision& decision, std::vector<TrackDetour> detours);
  void value(Decision& decision);
  double kept_alone(const Decision& decision, const Interval& range) const;
  double saving_of(Decision& decision, std::vector<TrackDetour>* best_detours);
  CurvedEncounter encounter_at(Decision& decision, std::size_t gap);

  const CurvedAvoidanceTask& task_;
  double width_m_;
  double least_m_;
  Surroundings around_;
  std::vector<Ring> body_;
  CurvedCover cover_;
  std::vector<bool> driven_;         ///< by track: has a piece
  std::vector<Decision> decisions_;  ///< BlockedTrack::strip is the track's place in the task
};

}  // namespace tramline
