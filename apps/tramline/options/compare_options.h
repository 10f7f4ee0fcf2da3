#pragma once
// The options of `compare`, which the Python package has in common with the program.

#include <string>
#include <vector>

#include "options/command_options.h"
#include "request/asked_plans.h"
#include "request/field_input.h"
#include "request/plan_request.h"

namespace tramline::app {

/// --widths and --machines as typed.
struct MachinesOptions {
  std::string widths, files;

  bool asked() const { return !widths.empty() || !files.empty(); }
};
void add_machines_options(CommandOptions& command, MachinesOptions& options);

struct CompareOptions {
  FieldOptions field;
  PlanOptions plan;
  std::vector<std::string> prices;  ///< each of --for
  MachinesOptions machines;
};
/// Declares all but those of output and run.
void add_compare_options(CommandOptions& command, CompareOptions& options);

/// What one machine is compared with.
struct AskedComparison {
  AskedPlans plans;
  std::vector<Objective> prices;  ///< those of --for
};
/// Takes conventions of papers into `options`. Throws kBadInput for options that cannot be compared with.
AskedComparison asked_comparison(const CommandOptions& command, CompareOptions& options);

/// Several machines, which are compared by their whole routes.
struct AskedMachines {
  std::vector<Machine> machines;
  Objective objective;
  PlanSettings settings;
};
/// Takes the defaults of plans to be driven into `options`. Throws kBadInput for options that ask for tracks
/// alone, and as machines_asked().
AskedMachines asked_machines(const CommandOptions& command, CompareOptions& options);

}  // namespace tramline::app
