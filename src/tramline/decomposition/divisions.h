#pragma once
// Ways of dividing a piece of ground that may pay.

#include <vector>

#include "tramline/decomposition/cuts.h"

namespace tramline {

struct DivisionTerms {
  double tolerance_m = 1;  ///< turns of the boundary smaller than this are no corners
  std::size_t most_corners = 8;
  std::size_t most_holes = 4;
  Direction driving;  ///< of the undivided ground
};

/// Sets of cuts, each of which divides the polygon into two parts or more:
/// - at the sharpest reflex corners, along either of the edges that meet there extended inwards, or along
///   the driving direction: to one side and, where that divides nothing, to both;
/// - beyond the two ends of each of the largest holes, along and across the driving direction.
std::vector<Region> divisions(const Polygon& polygon, const DivisionTerms& terms);

}  // namespace tramline
