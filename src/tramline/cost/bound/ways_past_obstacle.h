#pragma once
// How all strips that one obstacle reaches into get past it, together.

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "tramline/cost/bound/swath_edge.h"
#include "tramline/geometry/interval.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// A detour of one strip on one side of the obstacle.
struct SideWay {
  double cost = std::numeric_limits<double>::infinity();  ///< of what it works; infinite: no room
  PassedPlace place{};          ///< where it is displaced farthest; aside_m 0: not known
  std::vector<Point> passed{};  ///< points of the obstacle that its line, where it bends back, goes round
};

/// A strip that the obstacle may reach into, in the turned plane.
struct StripAtObstacle {
  double left = 0;                ///< its left line
  bool blocked = false;           ///< whether the obstacle is in the way in every grid
  double cut = 0;                 ///< cost of cutting the track, where it is
  std::array<SideWay, 2> ways{};  ///< on the left, on the right
  Interval clear{};               ///< rows with no boundary in the strip but the obstacle's
  Interval in_the_way{};  ///< rows that a track which is cut does not work: between its pieces at least
};

/// The obstacle and the terms of detours round it.
struct ObstacleTerms {
  const Ring& ring;
  double width_m = 1;
  double arc_m = 1;       ///< radius of the tightest arcs of a detour, at least half a width
  double across_m = 0;    ///< by how much the obstacle may lie elsewhere across
  double along_m = 0;     ///< and along
  Interval rows{};        ///< that are looked at
  double land_price = 0;  ///< of a square metre that nobody works: λo + λu
};

/// The least cost of getting the strips, from left to right and next to one another, past the obstacle: each
/// is cut or goes round on one side, and land between the obstacle and the innermost detours on either side
/// stays unworked (docs/bounds.md). No other detours come near. O(n²·(n + rows)) for n strips at worst.
double least_cost_past(const ObstacleTerms& terms, std::span<const StripAtObstacle> strips);

}  // namespace tramline
