#pragma once
// A plan file says some things twice. These functions find where it contradicts itself.

#include <string>
#include <vector>

#include "tramline/check/verdict.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Does the stored layer of swaths agree with the tracks and the working width? Corner by corner, to
/// 1e-6 m. `track_order` and `swath_order` are the stored numbers of plan.pieces and of `swaths`:
/// both have to be 1, 2, 3 … Rule "layers". O(p).
std::vector<Violation> compare_swaths(const Plan& plan, const std::vector<int>& track_order,
                                      const Region& swaths, const std::vector<int>& swath_order);

/// A stored number against the one its shape gives; equal to 1e-6, absolutely or relatively. Rule "layers".
void compare_number(const std::string& where, double stored, double from_shape, Point at,
                    std::vector<Violation>& out);

}  // namespace tramline::check
