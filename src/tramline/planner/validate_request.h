#pragma once
// Is this a request that can be planned?

#include "tramline/model/plan.h"

namespace tramline {

/// Throws kBadInput with one sentence where a number is missing, infinite, negative or out of range.
void validate_request(const Machine& machine, const Objective& objective, const PlanSettings& settings);

}  // namespace tramline
