#pragma once
// Places at which closed passes are entered, chosen together.

#include <optional>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/route/passes/worked_pass.h"

namespace tramline {

/// Passes in the given order (indices into Headland::passes), entered where the ways to all of them, and from
/// the last to the gate, take least together: a closed pass is left where it was entered, so the nearest
/// place to enter one need not be near to the next. None where the search finds nothing that takes less than
/// `limit_s`.
///
/// A* over places half a metre apart (or as much more as 1000 places of a long pass are) and over direct
/// ways, 500 at the most, which are looked for when the search comes to them. It foresees a change of lanes
/// from each pass to the next; across a corner one may take less, and then places a little better may be
/// missed.
///
/// `left`: the way of the axle up to there; empty where the route begins with the first pass, at the first of
/// its entries. Precondition: the passes lie along one boundary, and there is one.
std::optional<std::vector<WorkedPass>> at_best_places(const PassTask& task,
                                                      const std::vector<std::size_t>& order,
                                                      const SteeredPath& left, double limit_s);

}  // namespace tramline
