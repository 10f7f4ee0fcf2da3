#pragma once
// A sprayer on a field with oblique headlands, switched by its driver or by looking ahead.

#include "tramline/coverage/ahead/section_switch.h"

namespace tramline::testing {

/// The field is a parallelogram; its headland of one boom has been sprayed, and passes along its longer sides
/// remain, which end at the slanted edge of the headland.
struct Sprayer {
  double width_m = 24;
  double speed_mps = 3;
  double slant_deg = 45;  ///< between passes and the edge they end at
  int passes = 5;
  double tick_s = 0.1;      ///< how often is looked ahead, and commands are given
  double on_valve_s = 0.6;  ///< what valves take, whatever the rule says of them
  double off_valve_s = 0.4;
  coverage::SwitchRule rule{0.5, 0.5, 0.6, 0.4, 5};
};

struct Sprayed {
  double doubled_m2 = 0;
  double missed_m2 = 0;
  double sum_m2() const { return doubled_m2 + missed_m2; }
};

/// The boom as so many sections, each switched as looking ahead says, through valves that take their time.
Sprayed sprayed_looking_ahead(const Sprayer& sprayer, int sections);

/// The whole boom switched by a driver who never errs and never waits: on where the middle of the boom
/// crosses the edge, or, so that nothing is missed, as long as any of it lies over open ground.
enum class Driver { kAtTheMiddle, kMissesNothing };
Sprayed sprayed_by_hand(const Sprayer& sprayer, Driver driver);

}  // namespace tramline::testing
