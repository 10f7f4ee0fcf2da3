#include "tramline/planner/headland_choice/whole_sides.h"

#include <algorithm>
#include <cassert>

#include "tramline/geometry/polygon/significant_vertices.h"

namespace tramline {
namespace {

/// Corners nearer to the line between others belong to one side, in widths of the machine.
constexpr double kSameSide_share = 0.25;

}  // namespace

void take_whole_sides(const Ring& outer, double width_m, std::vector<int>& edge_passes) {
  assert(outer.size() >= 3 && edge_passes.size() == outer.size());
  const std::vector<std::size_t> ends = significant_vertices(outer, kSameSide_share * width_m);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::size_t first = ends[k], end = k + 1 < ends.size() ? ends[k + 1] : ends[0] + outer.size();
    int most = 0;
    for (std::size_t i = first; i < end; ++i) most = std::max(most, edge_passes[i % outer.size()]);
    for (std::size_t i = first; i < end; ++i) edge_passes[i % outer.size()] = most;
  }
}

}  // namespace tramline
