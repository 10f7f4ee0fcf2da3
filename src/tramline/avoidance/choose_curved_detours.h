#pragma once
// Which obstacles curved tracks go round, on which side, and where they are cut.

#include "tramline/avoidance/ground.h"
#include "tramline/model/machine.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// Everything the decisions about one family of tracks depend on. Refers to its arguments.
struct CurvedAvoidanceTask {
  const Field& field;
  const SortedGround& ground;
  const Machine& machine;
  const Objective& objective;
  const PlanSettings& settings;
  const TrackFamily& family;
  double body_m2 = 0;
};

struct CurvedAvoided {
  LaidTracks tracks;
  std::vector<std::vector<TrackDetour>> detours;  ///< by track of the task
  Tally tally;
  double cost = 0;
};

/// All tracks cut at obstacles.
CurvedAvoided all_cut(const CurvedAvoidanceTask& task);

/// The tracks with the detours the settings ask for, as choose_detours() for straight ones: `cheapest` gives
/// track by track the choice that costs least while the others stay as they are, again and again until none
/// changes, from all tracks cut; never costlier than that. S1's constructions are for straight tracks: with
/// `paper`, as with `cut`, all tracks are cut. Areas are cut by lines and arcs. Deterministic.
CurvedAvoided choose_detours(const CurvedAvoidanceTask& task);

/// An encounter with its place: `encounter.track` is the track's index in its family, sides are seen along
/// the track, and the subfield is left to the caller.
struct CurvedEncounter {
  Encounter encounter;
  int branch = 0;    ///< which of the track's paths
  Interval between;  ///< the stretch that cannot be driven, along the track
};

/// What was decided where, by track and place, as encounters_in().
std::vector<CurvedEncounter> encounters_in(const CurvedAvoidanceTask& task, const CurvedAvoided& avoided);

}  // namespace tramline
