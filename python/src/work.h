#pragma once
// The work behind the functions of the package. No Python in here, so none of it needs the interpreter's
// lock.

#include <optional>
#include <string>

#include "asked.h"
#include "plan_object.h"
#include "tramline/planner/progress.h"

namespace tramline::python {

/// The plan that `tramline plan` makes. Throws Error.
PlanObject planned(const PlanRequest& request, const Progress& progress);
/// The plans that `tramline compare` compares. Throws Error.
ComparisonObject compared(const PlanRequest& request, const Progress& progress);
/// The plan that given lines are. Throws Error.
PlanObject priced(const PriceRequest& request);
/// The drive of a log, or, where the request names none, of `plan`; a log is compared with it. Throws Error.
EvaluationObject evaluated(const EvaluateRequest& request, const std::optional<Plan>& plan,
                           const std::string& plan_name);
/// The JSON of `tramline check`. Throws Error.
std::string checked(const std::string& plan_file, const std::string& id, const app::FieldOptions& field);
/// The plan in a file, or that of a field in a file of many. Throws Error.
PlanObject read(const std::string& plan_file, const std::string& id);
/// The figures: those of `tramline plan --json`, or, of lines that were priced, of `tramline price --json`.
std::string json_of(const PlanObject& object);
/// The CRS in which the field was given, "EPSG:25832"; empty: plain metres.
std::string crs_of(const PlanObject& object);

}  // namespace tramline::python
