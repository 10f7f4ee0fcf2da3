#pragma once
// A lower bound on the cost of every grid of tracks near a given one.

#include <cstdint>
#include <limits>
#include <vector>

#include "tramline/cost/bound/detour_zones.h"
#include "tramline/cost/grid/grid_tally.h"
#include "tramline/model/objective.h"

namespace tramline {

/// A set of grids over one subfield around that of a GridTally: turned by up to `half_angle` either way,
/// about the pivot, and with line 0 up to `half_origin_m` to either side of `origin_m` (a coordinate across
/// in the turned plane, where the pivot stays as the grid turns).
struct GridBox {
  double origin_m = 0;
  double half_origin_m = 0;
  double half_angle = 0;  ///< radians, < 0.1
};

/// What is charged for land that detours may work.
enum class NearObstacles : std::uint8_t {
  kNothing,  ///< for a search that looks for grids; detours of more than ten widths may go beyond that land
  kCharged,  ///< the overlap of all that is worked there, for a proof
};

/// The other terms of a bound.
struct BoundTerms {
  Objective objective;
  Point pivot;              ///< in the field's plane
  double detour_reach = 0;  ///< radius of the arcs that detours are made of, m
  DetoursOf detours = DetoursOf::kThisGrid;
  NearObstacles near = NearObstacles::kNothing;
  /// Whether an obstacle lies beyond each edge of the part, the edges counted as those of
  /// TurnedSubfield::outline (edges_at_obstacles()). None where this is empty.
  std::vector<bool> at_obstacle{};
  bool drivable = true;  ///< whether nothing of a detour is tighter than those arcs
};

/// The cost of one subfield, λo·o + λu·u + λt·(pieces − crossings) + λs·stops, is at least this for every
/// grid of the box, whatever detours its tracks make: each strip is charged the least that its boundary can
/// cost, window by window (boundary_windows.h). A plain passage costs its wedge with the least slope it can
/// have (docs/bounds.md); elsewhere it is ∫ min(λo·(w − m), λu·m) dy over the cross-sections m(y) of the
/// middle grid, less what they can change by, or λu·m where no grid of the box drives (undriven_rows.h); and
/// λt for each piece that must be driven. Where λo and λu are far apart, lower values of the greater one
/// bound the cost too, and change less as the boundary moves: the best of them counts. Stretches that a
/// detour may come near are charged as the terms say (NearObstacles). Tends to the cost as the box shrinks,
/// obstacles apart, under the end rule `cheapest`. Strips are charged only until their sum has reached
/// `enough`: a smaller result is the whole bound, and a box that is no better than `enough` is recognised
/// sooner. O(n + K log K).
double least_cost(const GridTally& tally, const BoundTerms& terms, const GridBox& box,
                  double enough = std::numeric_limits<double>::infinity());

}  // namespace tramline
