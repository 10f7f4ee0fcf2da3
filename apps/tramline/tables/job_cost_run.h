#pragma once
// Whole plans of fields with one or several machines, and what they cost.

#include <optional>
#include <string>
#include <vector>

#include "request/field_input.h"
#include "request/plan_request.h"
#include "tramline/model/plan.h"

namespace tramline::app {

struct JobCostRun {
  std::vector<Machine> machines;
  Objective objective;
  PlanSettings settings;
  std::string csv_file{}, pdf_file{};  ///< empty: not written
  std::optional<double> seconds{};
  int threads = 0;
  bool json = false, quiet = false;
};

/// Plans every field with every machine and prints a table, with the sums of each machine below. A field that
/// cannot be planned with a machine is listed with the reason. Returns the exit code: 3 where some fields
/// were refused, 2 where all were. Throws kBadInput for machines and settings that cannot be planned with.
int run_job_costs(const JobCostRun& run, const FieldOptions& fields, const PlanOptions& options);

}  // namespace tramline::app
