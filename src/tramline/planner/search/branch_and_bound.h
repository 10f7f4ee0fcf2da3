#pragma once
// The best grids over one connected part of the land, over every direction and offset.

#include <functional>
#include <vector>

#include "tramline/planner/search/grid_pricing.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// Limits on the effort of a search.
struct SearchEffort {
  std::size_t most_edges = 64;   ///< directions of edges that are tried
  std::size_t edge_offsets = 4;  ///< offsets of the grid tried with each of them: 1 … 4
  std::size_t polished = 4;      ///< how many of the best of them are improved by small steps
  int scanned = 120;             ///< further directions tried, evenly spread
  int most_boxes = 5000;         ///< boxes to bound; 0: no branch and bound, and no bound
  double gap = 0.0075;           ///< stop when the bound is this near to the cost, relative
  Angle tolerance = Angle::degrees(0.01);
  bool cut_too = true;       ///< with obstacles: also improve the grids that are best with all tracks cut
  bool exact_offset = true;  ///< best_offset() for the best grid where no obstacle is in the way
};

struct BranchAndBoundResult {
  std::vector<PricedGrid> grids;  ///< the best found, cheapest first, no two alike; not empty
  /// The best grids if a stop cost no more than a turn, at that price; empty without obstacles.
  std::vector<PricedGrid> unhindered;
  double bound = 0;  ///< no grid costs less where no obstacle is in the way; else see bound_of_grids()
  int boxes = 0;
};

/// Returns what the land costs in another way, such as divided, given the best grid found by edges and small
/// steps (from `unhindered` where there are obstacles).
using Rival = std::function<double(const PricedGrid& best)>;

/// Branch and bound over boxes of direction × offset: grids flush with an edge, in all edge directions, are
/// the first incumbents; the box of least bound (least_cost) is divided next, and boxes that cannot hold
/// anything better are discarded. Directions nearer than the tolerance are not distinguished. Deterministic
/// for any number of threads. `rival`, where given, is called once: boxes that cannot hold anything cheaper
/// than its result are discarded as well, so that the bound of grids that do not win may stay further from
/// their cost.
BranchAndBoundResult branch_and_bound(const SearchTask& task, const Polygon& part, const SearchEffort& effort,
                                      const SearchContext& context, const Rival& rival = {});

/// A cost that no grid is below, whatever its detours, and the number of boxes it took.
struct ProvenBound {
  double bound = 0;
  int boxes = 0;
};

/// The best grid found, with its detours.
struct KnownGrid {
  double cost = 0;  ///< of the part by itself
  Direction direction;
  double origin_m = 0;  ///< coordinate of line 0 across the tracks, in the turned plane
};

/// The same search where obstacles are in the way, with a bound that charges the land near them too, and for
/// nothing but the bound. It ends where the bound is near to what it is of the known grid alone, which it
/// cannot exceed.
ProvenBound bound_of_grids(const SearchTask& task, const Polygon& part, const SearchEffort& effort,
                           const SearchContext& context, const KnownGrid& known);

}  // namespace tramline
