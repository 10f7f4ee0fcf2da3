#pragma once
// The driving order of a real field's plan, compared with a nearest-neighbour tour over the same ends.

#include <string>

#include "support/hops.h"
#include "tramline/model/field.h"
#include "tramline/model/plan.h"

namespace tramline::testing {

/// The longest hops that a plan may have, as a ratio to those of a nearest-neighbour tour.
inline constexpr double kMostHops = 1.2;

struct OrderScenario {
  double width_m = 6;
  int headlands = 0;
  TrackShape shape = TrackShape::kStraight;
};

struct OrderRun {
  std::string field_id;
  bool planned = false;  ///< and, where the scenario asks for curved tracks too, with them
  std::size_t pieces = 0;
  testing_support::Hops hops;
  double nearest_neighbour_m = 0;

  /// 1 where there is not a hop.
  double ratio() const { return nearest_neighbour_m > 0 ? hops.length_m / nearest_neighbour_m : 1; }
};

/// Plans on one thread, r = 6 m.
OrderRun run_order(const Field& field, const OrderScenario& scenario);

}  // namespace tramline::testing
