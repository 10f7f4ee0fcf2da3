#pragma once
// The cheapest grids of a search, no two of them nearly alike.

#include <vector>

#include "tramline/planner/search/grid_pricing.h"

namespace tramline {

struct FoundGrid {
  GridPosition position;
  double cost = 0;
  bool works = false;
  bool polished = false;  ///< no small step improves it
};

/// Grids with a piece rank first, then the cheaper: where turns are expensive, driving nothing is cheapest,
/// but that is no plan.
bool ranks_before(const FoundGrid& a, const FoundGrid& b);

/// A few of the cheapest grids; one that is much like a cheaper one is not kept.
class GridShortlist {
 public:
  explicit GridShortlist(double width_m) : width_m_(width_m) {}

  void offer(const FoundGrid& found);
  const std::vector<FoundGrid>& list() const { return list_; }
  const FoundGrid& best() const { return list_.front(); }

 private:
  bool alike(const GridPosition& a, const GridPosition& b) const;

  double width_m_;
  std::vector<FoundGrid> list_;  ///< cheapest first
};

}  // namespace tramline
