#pragma once
// Validates the numbers of a request.

#include "tramline/model/plan.h"

namespace tramline {

/// Throws kBadInput with one sentence where a number is missing, infinite, negative or out of range. A length
/// whose default is negative may be negative, but has to be finite and not too large.
void validate_request(const Machine& machine, const Objective& objective, const PlanSettings& settings);

/// Throws kBadInput with the sentence of validate_request() unless least <= value <= most; all in metres.
/// `what` names the value. For callers that take no negative number for the default.
void require_metres(double value, double least, double most, const char* what);

/// The names of these lengths in messages.
inline constexpr const char* kLeastTrackLength = "least track length";
inline constexpr const char* kAvoidThreshold = "avoid threshold";
inline constexpr const char* kAvoidRoom = "room for detours";

}  // namespace tramline
