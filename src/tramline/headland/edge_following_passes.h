#pragma once
// Passes in arms and narrow passages where the machine has no room to turn: along the edge from end to end.

#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/headland/pass_boundaries.h"

namespace tramline {

/// Paths that follow all boundaries together at the distance of pass `number`, wherever there is room for its
/// swath, whether or not the machine could turn there: closed, or open where it cannot get round a corner.
/// Open paths go straight on until their swaths reach a boundary. Each is given in the ways in which it may
/// be driven: one with a corner close to an end is given straight on before it first, and then round it.
/// Offset lines that follow no boundary with such a pass are left out. Together the paths follow the whole
/// offset line except for corners cut; the longest come first. O(n²) for n corners.
std::vector<std::vector<Path>> edge_following_passes(const std::vector<Boundary>& boundaries,
                                                     const HeadlandTerms& terms, int number);

}  // namespace tramline
