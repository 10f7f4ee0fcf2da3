#pragma once
// The boundary of a region cut at strips that are wider than those of the grid.

#include <span>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/geometry/strip/strip_grid.h"

namespace tramline {

/// A straight part of the boundary, as the boundary runs (the region on its left). x is measured from the
/// left line of its strip.
struct BoundaryPart {
  Point from;
  Point to;
  std::size_t edge = 0;  ///< of the outline, counted ring after ring
  double lowest() const { return std::min(from.y, to.y); }
  double highest() const { return std::max(from.y, to.y); }
};

/// Every edge cut at the sides of the strips that it meets. Kept from one collection to the next, for its
/// memory.
class StripParts {
 public:
  /// Strip k reaches from line k − margin_m to line k + 1 + margin_m. O(n + K).
  void collect(const std::vector<Ring>& outline, const StripGrid& grid, StripRange range, double margin_m);
  /// The parts in the strip range.first + i. Valid until the next call of collect.
  std::span<BoundaryPart> in(std::size_t i) {
    return {sorted_.data() + first_[i], first_[i + 1] - first_[i]};
  }

 private:
  std::vector<BoundaryPart> parts_, sorted_;
  std::vector<int> strip_;  ///< of each part, from 0
  std::vector<std::size_t> first_;
};

}  // namespace tramline
