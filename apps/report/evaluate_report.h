#pragma once
// The report of `evaluate`, as a table and as JSON.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "request/plan_and_done.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/coverage.h"
#include "tramline/model/tally.h"

namespace tramline::app {

/// A plan's own tally, for comparison with what its drive covers.
struct PlanTally {
  std::string plan;
  double land_m2 = 0;  ///< the area that the plan has to cover
  double body_m2 = 0;  ///< the part of it for tracks
  Tally tally;
};

struct Evaluation {
  Coverage coverage;
  coverage::RepeatRule repeat = coverage::RepeatRule::kRun;
  std::optional<PlanTally> tally;
  std::optional<PlanAndDone> compared;
  std::vector<std::string> with;  ///< plans whose drive was added to the log's
  double seconds = 0;
};

/// Whether a drive was evaluated on a field.
enum class FieldKnown { kNo, kYes };

/// {side_m, covered, missed}, each with `now` and `most`; missed is null without a field.
nlohmann::ordered_json meshes_json(const Meshes& meshes, FieldKnown field);
/// Keys: docs/json.md.
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation);
std::string evaluation_table(const Evaluation& evaluation);

}  // namespace tramline::app
