#pragma once
// In which directions the machine drove where it missed something.

#include <cstddef>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/coverage.h"

namespace tramline {

/// The directions in which each gap may be worked.
struct DrivenDirections {
  std::vector<Direction> directions;              ///< each once
  std::vector<std::vector<std::size_t>> of_gaps;  ///< indices into them, by gap; never none
};

/// Those in which most of the way at work was driven within a width of the gap (where none was, within four,
/// sixteen … of them): one, or two where the second has at least a third of the way of the first, as at the
/// end of rows. What differs by less than half a degree is one direction, that of the whole drive where it
/// has it. A slim gap may be worked along its own length too where that is no more than 10° off. Without any
/// drive gaps are worked along their length. Precondition: shapes with area. O(gaps · way near them).
DrivenDirections driven_directions(const std::vector<Gap>& gaps, const std::vector<DrivenLine>& driven,
                                   double width_m);

}  // namespace tramline
