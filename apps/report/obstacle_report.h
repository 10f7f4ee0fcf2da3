#pragma once
// What `plan` says about the ways its tracks take past obstacles.

#include <nlohmann/json.hpp>
#include <string>

#include "tramline/model/plan.h"

namespace tramline::app {

/// Rows of the table: the detours, and the meetings with obstacles that were cut, with the reasons.
/// Empty where no track meets an obstacle.
std::string obstacle_rows(const Plan& plan);

/// Why a track that meets an obstacle was cut, in a few words. Precondition: it was.
std::string reason_for_cut(const Encounter& encounter, Avoidance avoid);

/// Puts in the keys of docs/json.md from `avoid` to `encounters`.
void add_obstacle_keys(nlohmann::ordered_json& out, const Plan& plan);

}  // namespace tramline::app
