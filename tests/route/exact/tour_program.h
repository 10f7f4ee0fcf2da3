#pragma once
// The least tour by integer programming: another road than that of the planner.

#include "tramline/route/search/end_costs.h"

namespace tramline::testing {

struct LeastTour {
  double relaxed_s = 0;  ///< the least of the linear relaxation: no tour takes less
  double least_s = 0;    ///< of all tours, unless the time ran out
  bool proven = false;   ///< it did not
  int cuts = 0;          ///< of subtours
};

/// Connections are variables, 0 or 1; each end has one; each set of lines is entered and left, where a
/// solution would make a ring of it (Dantzig, Fulkerson and Johnson 1954). CLP solves the relaxation with all
/// cuts that it violates, then CBC what can be part of a tour better than `known_s`, with cuts where a
/// solution is not one ring. Where no tour takes less than `known_s`, that is the least. `seconds`: for each
/// solution of CBC.
LeastTour least_tour(const order::EndCosts& costs, double known_s, double seconds);

}  // namespace tramline::testing
