#pragma once
// The best grids over one connected piece of ground: every direction, every offset.

#include <functional>
#include <vector>

#include "tramline/planner/search/grid_pricing.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// How hard to look.
struct SearchEffort {
  std::size_t most_edges = 64;   ///< directions of edges that are tried
  std::size_t edge_offsets = 4;  ///< of the grid, to each of them: 1 … 4
  std::size_t polished = 4;      ///< of the best of them: how many are bettered by small steps
  int scanned = 120;             ///< directions, evenly spread, that are looked at besides
  int most_boxes = 5000;         ///< that are bounded; 0: no branch and bound, and no bound
  double gap = 0.0075;           ///< stop where the bound is this near, relative
  Angle tolerance = Angle::degrees(0.01);
  bool cut_too = true;       ///< where obstacles are, better also the grids that are best with all tracks cut
  bool exact_offset = true;  ///< best_offset() for the best grid, where no obstacle hinders
};

struct BranchAndBoundResult {
  std::vector<PricedGrid> grids;  ///< the best found, cheapest first, no two alike; not empty
  /// The best if a stop cost no more than a turn, priced so; empty where no obstacle is.
  std::vector<PricedGrid> unhindered;
  double bound = 0;  ///< no grid, with whatever detours, costs less
  int boxes = 0;
};

/// What the ground costs otherwise, told the best grid found by edges and small steps (`unhindered` where
/// obstacles are).
using Rival = std::function<double(const PricedGrid& best)>;

/// Branch and bound over boxes of direction × offset: all edge directions with the grid flush with the
/// edge are the first incumbents, the box of least bound (least_cost) is divided next, and no box is looked
/// into that cannot hold anything better. Directions nearer than the tolerance are one. Deterministic for
/// any number of threads.
/// `rival`, where given, is asked once: boxes that cannot hold anything cheaper than that are not looked
/// into either, so that the bound of grids that do not win may stay further from their cost.
BranchAndBoundResult branch_and_bound(const SearchTask& task, const Polygon& part, const SearchEffort& effort,
                                      const SearchContext& context, const Rival& rival = {});

}  // namespace tramline
