#pragma once
// The parts of the land that a machine cannot drive between, and the work on each.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/model/headland.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/connection/driving_ground.h"

namespace tramline {

/// Indices of route lines and of headland passes.
struct PartWork {
  std::vector<std::size_t> lines{};
  std::vector<std::size_t> passes{};
  std::optional<Point> next{};  ///< the corner of the part driven next that is nearest to this one
};

/// Where a route begins and ends, if that was asked for.
struct RouteEnds {
  std::optional<Point> start{};
  std::optional<Point> end{};
};

/// Lines and passes by the part of the land they lie on. Two parts are joined only by land narrower than the
/// outline, which nobody drives through: a route leaves the land between them, and does so least often where
/// it finishes one before it goes to the next. In driving order: first the part where the route starts, or
/// that of the most work, then the nearest each time, and last the one where the route ends. All in one where
/// passes have sharp corners, which are no part of a bound. Deterministic. O(n·m) for n corners and m
/// lines and passes, besides one polygon erosion.
std::vector<PartWork> work_by_part(const std::vector<RouteLine>& lines, const Headland& headland,
                                   const RouteEnds& ends, const DrivingGround& ground);

}  // namespace tramline
