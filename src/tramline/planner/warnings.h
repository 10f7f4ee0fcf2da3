#pragma once
// What a user should know about a finished plan.

#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline {

/// One line each: swaths past the boundary and by how much, land given up between obstacles, dropped
/// pieces, and that connections between pieces are not planned.
std::vector<std::string> warnings_about(const Plan& plan);

}  // namespace tramline
