#pragma once
// Divisions of a piece of land that may pay.

#include <vector>

#include "tramline/decomposition/cuts.h"

namespace tramline {

struct DivisionTerms {
  double tolerance_m = 1;  ///< bends of the boundary within this distance are no corners
  std::size_t most_corners = 8;
  std::size_t most_holes = 4;
  Direction driving;  ///< of the undivided land
};

/// The parts of the polygon for sets of cuts, each of which divides it into two parts or more:
/// - at the sharpest reflex corners, along either of the edges that meet there extended inwards, or along
///   the driving direction: to one side and, where that divides nothing, to both;
/// - at the two ends of each of the largest holes, along and across the driving direction.
std::vector<Region> divisions(const Polygon& polygon, const DivisionTerms& terms);

}  // namespace tramline
