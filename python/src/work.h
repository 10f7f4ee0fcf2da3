#pragma once
// The work behind the functions of the package. No Python in here, so none of it needs the interpreter's
// lock.

#include <cstddef>
#include <optional>
#include <string>

#include "asked.h"
#include "plan_object.h"
#include "tramline/planner/progress.h"

namespace tramline::python {

/// The plan that `tramline plan` makes. Throws Error.
PlanObject planned(const PlanRequest& request, const Progress& progress);
/// Throws kBadInput for a machine, prices or settings with which no field could be planned.
void require_plannable(const PlanRequest& request);
/// The plans, or the machines, that `tramline compare` compares. Throws Error.
ComparisonObject compared(const CompareRequest& request, const Progress& progress);
/// A plan of the front, numbered from 1. Throws kBadInput where there is none of this number.
PlanObject plan_at(const ComparisonObject& object, std::size_t point);
/// The plan that given lines are, and the one that they are to be compared with. Throws Error.
PlanObject priced(const PriceRequest& request, const Progress& progress);
/// The JSON of `tramline price --compare`; empty where nothing was compared.
std::string comparison_of(const PlanObject& object);
/// The plan that lines were compared with.
std::optional<PlanObject> planned_beside(const PlanObject& object);
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
