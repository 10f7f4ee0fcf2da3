#pragma once
// The land a plan is made on, with the obstacles sorted into Versleijen's categories.

#include "tramline/avoidance/obstacles/hazards.h"
#include "tramline/model/field.h"

namespace tramline {

/// Local metres. body = plannable ∪ given_up − passable; the parts of given_up and of the obstacles
/// are hard: no swath enters them.
struct ClassifiedGround {
  Region body;       ///< what has to be covered (glossary: body)
  Region plannable;  ///< field minus obstacles and given-up land; passable obstacles still in it
  Region given_up;   ///< land no swath may work: between clustered obstacles, between an obstacle and
                     ///< the edge, inside a ring of them, and nearer to one than the clearance
  Region hard;       ///< obstacles and given-up land
  Region passable;   ///< crossed with the work interrupted
  Region beyond;     ///< land outside the field nearer to an obstacle than the clearance, and given-up land
                     ///< in headlands: no swath enters it, and an end before it is no stop
  std::vector<Hazard> hazards;  ///< the parts of `hard` with what lies beyond
};

/// Versleijen table 3: clusters (b) and edge clips (c). Every other obstacle is driven round (a) or cuts the
/// swaths it meets (d), which is decided track by track. No swath comes nearer to an obstacle than
/// `clearance_m`.
ClassifiedGround classify_obstacles(const Field& field, double width_m, double clearance_m = 0);

}  // namespace tramline
