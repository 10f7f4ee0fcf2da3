#pragma once
// Headland passes by the boundary that they go along.

#include <vector>

namespace tramline {

/// Headland passes by edge of the field's outer ring and by obstacle.
struct PassesByBoundary {
  std::vector<int> edges;
  std::vector<int> obstacles;

  friend bool operator==(const PassesByBoundary&, const PassesByBoundary&) = default;
};

}  // namespace tramline
