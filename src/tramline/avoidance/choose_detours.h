#pragma once
// The choice of which obstacles are driven round, on which side, and which tracks are cut.

#include <cstdint>

#include "tramline/avoidance/choice/decision.h"
#include "tramline/avoidance/obstacles/surroundings.h"
#include "tramline/model/machine.h"
#include "tramline/model/plan.h"

namespace tramline {

/// The input of the decisions of one candidate. Refers to its arguments.
struct AvoidanceTask {
  const Field& field;
  const ClassifiedGround& ground;
  const Machine& machine;
  const Objective& objective;
  const PlanSettings& settings;
  const std::vector<Subfield>& subfields;
  const std::vector<TrackFamily>& families;  ///< by subfield; or one along a curve over all of them
  double body_m2 = 0;
};

struct Avoided {
  std::vector<LaidTracks> tracks;  ///< by family
  Tally tally;
  double cost = 0;
  std::vector<Decision> decisions;  ///< the ways found past obstacles; none where all tracks are to be cut
  WaysPast ways = WaysPast::kOwn;   ///< those that the detours were chosen from
};

/// Sets the tally and the cost that the tracks come to, detours included.
void settle_cost(const AvoidanceTask& task, Avoided& avoided);

/// Whether a is cheaper than b and not just by working nothing: where turns are expensive nothing costs less
/// than to stay at home.
bool is_better(const Avoided& a, const Avoided& b);

/// The tracks with the detours that the settings ask for:
/// - cut: none (Versleijen fig. 20);
/// - paper: Versleijen's (§2.2.4), each track for itself;
/// - cheapest: track by track the choice that costs least while the others stay as they are, again and
///   again until none changes, from the first plan above. Where Versleijen's plan is cheaper still, the
///   search goes on from there, Versleijen's ways among the choices: never costlier than either.
/// Costs are exact: every area is cut by lines and arcs. Deterministic.
Avoided choose_detours(const AvoidanceTask& task);

/// An encounter with its position on the track.
struct PlacedEncounter : Encounter {
  int branch = 0;    ///< Track::branch
  Interval between;  ///< the stretch that cannot be driven, along the track
};

/// The decisions at all gaps of tracks laid by choose_detours, by family, track and position.
/// Encounter::subfield is the family, Encounter::track is Track::index, sides are seen along the track, and
/// costs are those of the best choice for the track with that way at this position, above the best one with a
/// cut. Ways already found are reused; where all tracks were to be cut they are searched for now.
std::vector<PlacedEncounter> encounters_in(const AvoidanceTask& task, const Avoided& avoided);

}  // namespace tramline
