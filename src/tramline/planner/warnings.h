#pragma once
// Warnings about a finished plan.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/model/plan.h"
#include "tramline/planner/search_result.h"

namespace tramline {

/// The warning of every plan without a route.
inline constexpr const char* kConnectionsUnplanned =
    "connections between tracks are not planned yet: only the order of the pieces is";

/// The warnings about a plan, one line each: much land that stays unworked, and how much of it is narrower
/// than the machine, warnings about the field, swaths past the boundary and by how much, land given up
/// between obstacles, dropped and short pieces, and kConnectionsUnplanned or, with a route, the legs on which
/// it leaves the land.
std::vector<std::string> warnings_about(const Plan& plan);

/// Adds that the route works so many parts of the land one after the other; nothing where it is one.
void add_parts(std::size_t parts, std::vector<std::string>& warnings);

/// Adds what the sweep left out to the warnings of warnings_about().
void add_limits(const SweepLimits& limits, std::vector<std::string>& warnings);

/// Adds how many ends of tracks were made shorter by an amount worth saying, and by how much at the most.
void add_shorter_ends(const Candidate& candidate, std::vector<std::string>& warnings);

/// Marks a plan as that of a search that was ended early, in Proof::cut_short and in a warning.
void mark_cut_short(Plan& plan);

/// The warning for a plan that leaves more than 2 % of its land unworked; empty for any other.
std::string unworked_land_warning(const Plan& plan);

}  // namespace tramline
