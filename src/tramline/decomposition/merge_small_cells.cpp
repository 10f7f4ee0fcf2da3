#include "tramline/decomposition/merge_small_cells.h"

namespace tramline {
namespace {

bool longest_edge_of(const MergeNode& node, double length) {
  for (const auto& [neighbour, other] : node.shared)
    if (other > length) return false;
  return true;
}

double shared_length(const MergeNode& a, const MergeNode& b) {
  // Every node's first cell is its own index in the graph until it is merged away.
  const auto found = a.shared.find(b.cells.front());
  return found == a.shared.end() ? 0 : found->second;
}

}  // namespace

MergeRule small_cells(double small_cell_m2) {
  return {[small_cell_m2](const MergeNode& a, const MergeNode& b) {
            const double length = shared_length(a, b);
            return (a.area_m2 < small_cell_m2 && longest_edge_of(a, length)) ||
                   (b.area_m2 < small_cell_m2 && longest_edge_of(b, length));
          },
          MergeRule::Opens::kWithAnyChange};
}

void merge_small_cells(MergeGraph& graph, double small_cell_m2) {
  merge_longest_edge_first(graph, Remember::kLargerOnly, small_cells(small_cell_m2));
}

}  // namespace tramline
