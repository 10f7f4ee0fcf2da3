#pragma once
// Passes where the machine has no room to turn: in arms and necks, along the edge from end to end.

#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/headland/pass_boundaries.h"

namespace tramline {

/// Paths that follow all boundaries together at the distance of pass `number`, wherever there is room for its
/// swath, whether the machine could turn there or not: closed, or open where it cannot get round a corner.
/// These go straight on until their swaths come to a boundary. Levels that follow none with such a pass are
/// left out. Between them the paths follow the whole level but for corners cut; the longest come first.
/// O(n²) for n corners.
std::vector<Path> edge_following_passes(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                        int number);

}  // namespace tramline
