#pragma once
// One candidate of the search: a decomposition with its tracks and what it costs.

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
  std::vector<SubfieldTracks> tracks;  ///< by subfield
  Tally tally;
  double cost = 0;
};

SearchTask search_task(const Field& field, const Machine& machine, const Objective& objective,
                       const PlanSettings& settings);

/// S1.19: decompose, merge, lay tracks, tally. Pure; safe to call from several threads.
Candidate evaluate(const SearchTask& task, Direction sweep);

}  // namespace tramline
