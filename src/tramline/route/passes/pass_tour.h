#pragma once
// The order in which headland passes are worked, and from where.

#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/route/passes/worked_pass.h"

namespace tramline {

/// These passes, each once, from where the route is (`left`: the way of the axle up to there; empty: nowhere
/// yet, then the first of them begins at its own beginning). Of those whose turn it is by `sequence`, which
/// is of passes along one boundary by their numbers, that comes next which takes least driving time with what
/// lies ahead (NextPass); or the nearest, where the whole takes less so. Closed ones are entered where the
/// ways take least together (at_best_places()); where there is not room for that, each at the place reached
/// soonest with room. With kAny, of this order, outwards and inwards the one that lacks room least often and
/// takes least. O(p²) ways for p passes. Precondition: there is a pass.
std::vector<WorkedPass> pass_tour(const PassTask& task, const SteeredPath& left);

}  // namespace tramline
