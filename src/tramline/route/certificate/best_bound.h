#pragma once
// Prices of the nodes that make the bound of a route large.

#include <cstddef>
#include <vector>

#include "tramline/route/certificate/connection_bounds.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::order {

struct PricedBound {
  std::vector<double> prices_s;  ///< by node
  double bound_s = 0;            ///< bound_of() these prices
};

struct AscentEffort {
  /// What the connections of a known route take, s: the bound cannot rise above it, and how far it is below
  /// decides how large the steps are.
  double known_s = 0;
  std::size_t steps = 0;  ///< 0: usual_steps()
  double enough_s = 0;    ///< it ends where the bound is no farther below the known route than this
};

/// How many steps best_bound() takes where none are asked for.
std::size_t usual_steps(std::size_t lines);

/// Prices found by subgradient ascent (Held and Karp 1971) over near nodes, and the bound that they prove
/// over all nodes. Where near nodes were not all that matter, those missing are added and the ascent goes on.
/// Deterministic. Preconditions: a line or a ring, at most two gates, known_s ≥ 0.
PricedBound best_bound(const ConnectionBounds& bounds, const AscentEffort& effort);
/// The same where near nodes are known.
PricedBound best_bound(const ConnectionBounds& bounds, const Neighbours& near, const AscentEffort& effort);

}  // namespace tramline::order
