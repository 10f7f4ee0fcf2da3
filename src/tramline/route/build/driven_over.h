#pragma once
// What a route drives over with the work off.

#include "tramline/model/plan.h"

namespace tramline {

/// Fills in Route::over_worked_m, over_unworked_m and over_tracks_m of a route over the pieces and passes of
/// a plan: of the axle's way, in steps of at most kDrivenOverStep_m. Land that no piece and no pass works
/// counts as neither. O(length · swaths at one place).
void add_driven_over(Plan& plan);

inline constexpr double kDrivenOverStep_m = 1;

}  // namespace tramline
