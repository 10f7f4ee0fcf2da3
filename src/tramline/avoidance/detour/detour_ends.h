#pragma once
// Where a detour in the making leaves its track and comes back to it.

#include <functional>

#include "tramline/avoidance/detour/way_round.h"

namespace tramline {

/// What one look at a detour in the making comes to.
enum class Look { kDone, kLookAgain, kGaveUp };

/// Both ends have to lie on stretches that may be driven, before the gap `gap` and behind the gap `last_gap`:
/// then the way bridges what lies between. If not, `add_gap` is told of the gaps the detour reaches, and says
/// whether it learns of anything there that the detour has to go round, too. The reason stands in `way`
/// where it does not. O(n) for n stretches.
Look look_at_ends(const Intervals& stretches, std::size_t gap, std::size_t last_gap,
                  const std::function<bool(const Interval&)>& add_gap, WayRound& way);

}  // namespace tramline
