#pragma once
// Is this a request that can be planned?

#include "tramline/model/plan.h"

namespace tramline {

/// Throws kBadInput with one sentence where a number is missing, infinite, negative or out of range; of
/// lengths with a negative default only what is not finite or too large.
void validate_request(const Machine& machine, const Objective& objective, const PlanSettings& settings);

/// Throws kBadInput with the sentence of validate_request() unless least <= value <= most; all in metres.
/// `what` names the value. For callers that take no negative number for the default.
void require_metres(double value, double least, double most, const char* what);

/// What those two lengths are called there.
inline constexpr const char* kLeastTrackLength = "least track length";
inline constexpr const char* kAvoidThreshold = "avoid threshold";

}  // namespace tramline
