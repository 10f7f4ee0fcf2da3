#pragma once
// One candidate of the search: a decomposition with its tracks and what it costs.

#include "tramline/avoidance/choose_detours.h"
#include "tramline/avoidance/ground.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/strip_pieces.h"

namespace tramline {

/// What every candidate of one search shares.
struct SearchTask {
  Field field;
  Machine machine;
  Objective objective;
  PlanSettings settings;
  Ground ground;
  double body_m2 = 0;
};

struct Candidate {
  Direction sweep;
  std::vector<Subfield> subfields;
  std::vector<Strips> strips;  ///< by subfield
  Avoided avoided;             ///< the tracks, their tally and cost

  double cost() const { return avoided.cost; }
};

SearchTask search_task(const Field& field, const Machine& machine, const Objective& objective,
                       const PlanSettings& settings);

/// S1.19: decompose, merge, lay tracks, get them past the obstacles, tally. Pure; safe to call from
/// several threads.
Candidate evaluate(const SearchTask& task, Direction sweep);

/// What was decided where its tracks meet obstacles; as encounters_in gives it.
std::vector<Encounter> encounters_of(const SearchTask& task, const Candidate& candidate);

/// The strip that is track 0 of a subfield: the first that is driven or meets an obstacle.
int first_track(const Candidate& candidate, std::size_t subfield);

}  // namespace tramline
