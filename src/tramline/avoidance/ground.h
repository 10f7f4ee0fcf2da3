#pragma once
// The ground a plan is made on, once the obstacles are sorted into S1's categories.

#include "tramline/model/field.h"

namespace tramline {

/// Local metres. body = plannable ∪ given_up − passable; the parts of given_up and of the obstacles
/// are hard: no swath enters them.
struct Ground {
  Region body;       ///< what has to be covered (DESIGN: field minus obstacles)
  Region plannable;  ///< field minus obstacles and given-up land; passable obstacles still in it
  Region given_up;   ///< land no swath may work: between clustered obstacles, between an obstacle and
                     ///< the edge, and inside a ring of them
  Region hard;       ///< obstacles and given-up land
  Region passable;   ///< crossed with the work interrupted
};

/// S1.27-S1.29: clusters (b) and edge clips (c); every other obstacle cuts the swaths it meets (d).
Ground sort_obstacles(const Field& field, double width_m);

}  // namespace tramline
