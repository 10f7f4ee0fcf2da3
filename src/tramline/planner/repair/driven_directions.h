#pragma once
// The directions in which the machine drove near the gaps.

#include <cstddef>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/coverage.h"

namespace tramline {

/// The directions in which each gap may be worked.
struct DrivenDirections {
  std::vector<Direction> directions;              ///< all distinct
  std::vector<std::vector<std::size_t>> of_gaps;  ///< indices into directions, by gap; at least one for each
};

/// For each gap the directions in which the machine drove most of its working distance within one width of
/// the gap (where it drove none, within four, sixteen … widths): one, or two where the second has at least a
/// third of the distance of the first, as at the ends of rows. Directions that differ by less than half a
/// degree are one, chosen from the directions of the whole drive where it has such. A slim gap may also be
/// worked along its own length where that is no more than 10° off. Without any drive gaps are worked along
/// their length. Precondition: shapes with area. O(gaps · way near them).
DrivenDirections driven_directions(const std::vector<Gap>& gaps, const std::vector<DrivenLine>& driven,
                                   double width_m);

}  // namespace tramline
