#pragma once
// What a user should know about a finished plan.

#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline {

/// What holds for every plan.
inline constexpr const char* kConnectionsUnplanned =
    "connections between tracks are not planned yet: only the order of the pieces is";

/// One line each: much land that stays unworked, what was said of the field, swaths past the boundary and by
/// how much, land given up between obstacles, dropped and short pieces, and kConnectionsUnplanned.
std::vector<std::string> warnings_about(const Plan& plan);

/// Says of a plan that its search was ended before it was through, in Proof::cut_short and in a warning.
void mark_cut_short(Plan& plan);

/// The sentence for a plan that leaves more than 2 % of the land it is there to work; empty for any other.
std::string unworked_land_warning(const Plan& plan);

}  // namespace tramline
