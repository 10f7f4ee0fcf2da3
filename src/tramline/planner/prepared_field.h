#pragma once
// What is derived from a problem once, before any search.

#include "tramline/avoidance/obstacles/obstacle_classification.h"
#include "tramline/model/headland.h"

namespace tramline {

/// A field ready to be searched: its obstacles sorted, its headlands taken off. Local metres.
struct PreparedField {
  ClassifiedGround ground;  ///< where there are headlands: what they leave
  double body_m2 = 0;       ///< area of the ground's body
  Headland headland;        ///< empty without any
  /// Corners between edges that are both shorter split nothing: PlanSettings::short_edge_m, or more where
  /// headlands have rounded corners.
  double short_edge_m = 0;
  /// The field where its boundary is where swaths end; empty where it is soft, and where it has a headland:
  /// wherever a swath is driven it has body across it, which lies at least a width from the boundary, and so
  /// no swath, straight or curved, gets past that however far its end rule lets it run on.
  Region hard_field;
  bool clearance_takes_all = false;  ///< there is ground to work without the clearance, and none with it
};

}  // namespace tramline
