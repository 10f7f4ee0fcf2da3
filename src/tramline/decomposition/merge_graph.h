#pragma once
// Cells and the edges they share, merged pair by pair.

#include <map>
#include <vector>

#include "tramline/decomposition/cells.h"
#include "tramline/model/plan.h"

namespace tramline {

/// One subfield in the making.
struct MergeNode {
  std::vector<std::size_t> cells;  ///< members, by index of the original cell
  double area_m2 = 0;
  Direction direction;             ///< see merge()
  std::vector<Direction> history;  ///< directions that every later merge must respect (fig. 16), ascending
  std::map<std::size_t, double> shared;  ///< length of the common edge by neighbour, m
  bool alive = true;
};

struct MergeGraph {
  std::vector<Cell> cells;
  std::vector<MergeNode> nodes;  ///< a merged node stays at the lower index of the two
};

/// Neighbours are cells that share an edge of positive length. O(n log n) in the number of edges.
MergeGraph merge_graph(std::vector<Cell> cells);

/// Whether the directions of both nodes enter the history, or only that of the larger one.
enum class Remember { kBoth, kLargerOnly };
/// Joins b into a: the larger of the two keeps its direction (Versleijen §2.2.3; a tie: the lower index).
/// Precondition: a < b, both alive and neighbours.
void merge(MergeGraph& graph, std::size_t a, std::size_t b, Remember remember);

/// The subfields: the union of each node's cells, by node index.
std::vector<Subfield> subfields_of(const MergeGraph& graph);

}  // namespace tramline
