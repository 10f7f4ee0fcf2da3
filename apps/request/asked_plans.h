#pragma once
// What is asked of the planner, for one field or many.

#include <map>
#include <optional>
#include <string>

#include "request/field_input.h"
#include "request/given_land.h"
#include "request/plan_request.h"
#include "tramline/model/machine.h"
#include "tramline/model/objective.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// The machine, the objective and the settings that the options stand for. Options that are not given have to
/// have their defaults (whole_plan_defaults()) by then.
class AskedPlans {
 public:
  AskedPlans() = default;
  /// Reads the machine file, and nothing else. Throws kBadInput.
  explicit AskedPlans(const PlanOptions& options);

  /// Reads the line to follow, the gates and the files of `land`, and adds to `input.skipped` what of them
  /// meets no field. Throws kBadInput.
  void read_files(const PlanOptions& options, const LandOptions& land, FieldInput& input);

  const Machine& machine() const { return machine_; }
  const Objective& objective() const { return objective_; }
  /// With the line, the gates and the land of this field. Throws kBadInput where no gate is near.
  PlanSettings settings_on(const Field& field) const;

 private:
  void read_land(const LandOptions& land, FieldInput& input);

  Machine machine_;
  Objective objective_;
  PlanSettings settings_;
  std::optional<GuideLine> guide_;
  Gates gates_;
  std::map<std::string, GivenLand> given_;  ///< by field_key()
};

}  // namespace tramline::app
