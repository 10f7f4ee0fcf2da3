#pragma once
// A field with obstacles planned in each of the three ways of getting past them, and compared.

#include <string>
#include <vector>

#include "real/real_fields.h"

namespace tramline::testing {

/// What of a plan is compared.
struct PlanFigures {
  Tally tally;
  double cost = 0;
  int met = 0;    ///< encounters of tracks with obstacles
  int round = 0;  ///< those driven round
  int tight = 0;  ///< detours tighter than the machine can follow
  int directions_tried = 0;
  double seconds = 0;  ///< processor time of planning on one thread
};

/// How one field fared with one machine at default prices and settings.
struct ObstacleRun {
  std::string field_id;
  std::string refused;              ///< why there is no plan; empty when there is one
  std::vector<std::string> faults;  ///< everything that must not be
  PlanFigures cheapest;
  PlanFigures paper;
  PlanFigures cut;
};

PlanFigures figures_of(const Plan& plan);

/// Plans on one thread and measures it.
PlanFigures planned(const Field& field, const Machine& machine, const Objective& objective, Avoidance avoid,
                    Plan& plan);

/// Plans a field in all three ways and verifies each: the cheapest through its plan file, `scratch`. Faults
/// are also a plan that costs more than with all tracks cut, or more than by the paper's rule where that can
/// be driven, and a direction that was not tried in each way.
ObstacleRun run_obstacles(const Field& field, const Field& input, const Machine& machine,
                          const std::string& scratch);

}  // namespace tramline::testing
