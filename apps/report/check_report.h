#pragma once
// The report of `tramline check`: a table for people, an object for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// Stored and recomputed figures with their units, every violation with its position, and the verdict last.
std::string check_table(const std::string& plan_file, const Plan& plan, const check::Verdict& verdict);

/// {plan, field_id, ok, complete, violations, recomputed, stored, not_verified}; recomputed is null where
/// nothing could be recomputed.
nlohmann::ordered_json check_json(const std::string& plan_file, const Plan& plan,
                                  const check::Verdict& verdict);

}  // namespace tramline::app
