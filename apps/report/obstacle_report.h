#pragma once
// The report of `plan` on the ways of its tracks past obstacles.

#include <nlohmann/json.hpp>
#include <string>

#include "tramline/model/plan.h"

namespace tramline::app {

/// Rows of the table: the detours, and the encounters where tracks are cut, with the reasons. Empty where no
/// track reaches an obstacle.
std::string obstacle_rows(const Plan& plan);

/// The reason why a track is cut at an obstacle, in a few words. Precondition: it is.
std::string reason_for_cut(const Encounter& encounter, Avoidance avoid);

/// Adds the keys of docs/json.md from `avoid` to `encounters`.
void add_obstacle_keys(nlohmann::ordered_json& out, const Plan& plan);

}  // namespace tramline::app
