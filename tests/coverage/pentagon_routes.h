#pragma once
// Routes over the pentagon of Zhang §3.1, each worked out in full: what every engine of coverage is held
// against.

#include <string>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage::testing_routes {

/// A route of straight rows and of the legs between them, all worked. Every row and every leg is a run of its
/// own, a rectangle with flat ends: none of what they have in common is a trail of their own.
struct PentagonRoute {
  std::string name;
  std::vector<Ring> rectangles;   ///< one a run, in the order of driving, counter-clockwise
  std::vector<WorkedStep> steps;  ///< the same in steps of no more than a metre
  double covered_m2 = 0;          ///< by polygon booleans, to 0.0005 m²
  double repeated_m2 = 0;         ///< worked twice or more often
  double missed_m2 = 0;           ///< of the pentagon
};

/// The pentagon A1 to A5, counter-clockwise: 983.125 m².
Region pentagon();

/// Working width of all of them, m.
inline constexpr double kRouteWidth_m = 4;

std::vector<PentagonRoute> routes();

}  // namespace tramline::coverage::testing_routes
