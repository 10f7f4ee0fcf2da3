#pragma once
// What a field's plan was made from, as a text to recognise it by.

#include <string>

#include "tramline/model/plan.h"

namespace tramline::app {

/// Differs wherever the plan of a field or the files of it may: field, machine, objective and settings to the
/// last bit, `wanted` (what is asked for besides, and under which names) and the version of the program.
/// `plan` has to hold only those four. O(n) in vertices.
std::string made_from_text(const Plan& plan, const std::string& wanted);

}  // namespace tramline::app
