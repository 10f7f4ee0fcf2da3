#include "tramline/decomposition/merge_graph.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>

#include "tramline/geometry/polygon/faces.h"

namespace tramline {
namespace {

struct CellEdge {
  std::array<double, 4> key;  ///< the two ends, the smaller first
  std::size_t cell;
};

void append_edges(const Ring& ring, std::size_t cell, std::vector<CellEdge>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    std::array<double, 2> a{ring[i].x, ring[i].y};
    std::array<double, 2> b{ring[(i + 1) % ring.size()].x, ring[(i + 1) % ring.size()].y};
    if (b < a) std::swap(a, b);
    out.push_back({{a[0], a[1], b[0], b[1]}, cell});
  }
}

void find_neighbours(MergeGraph& graph) {
  std::vector<CellEdge> edges;
  for (std::size_t c = 0; c < graph.cells.size(); ++c) {
    append_edges(graph.cells[c].shape.outer, c, edges);
    for (const Ring& hole : graph.cells[c].shape.holes) append_edges(hole, c, edges);
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const CellEdge& a, const CellEdge& b) { return a.key < b.key; });
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const CellEdge &one = edges[i], &other = edges[i + 1];
    if (one.key != other.key || one.cell == other.cell) continue;
    const double length = std::hypot(one.key[2] - one.key[0], one.key[3] - one.key[1]);
    graph.nodes[one.cell].shared[other.cell] += length;
    graph.nodes[other.cell].shared[one.cell] += length;
  }
}

void join_histories(MergeNode& into, const MergeNode& other) {
  std::vector<Direction> both;
  std::set_union(into.history.begin(), into.history.end(), other.history.begin(), other.history.end(),
                 std::back_inserter(both));
  into.history = std::move(both);
}

}  // namespace

MergeGraph merge_graph(std::vector<Cell> cells) {
  MergeGraph graph{std::move(cells), {}};
  for (std::size_t c = 0; c < graph.cells.size(); ++c) {
    const Cell& cell = graph.cells[c];
    graph.nodes.push_back({{c}, area(cell.shape), cell.direction, {cell.direction}, {}, true});
  }
  find_neighbours(graph);
  return graph;
}

void merge(MergeGraph& graph, std::size_t a, std::size_t b, Remember remember) {
  assert(a < b && b < graph.nodes.size());
  assert(graph.nodes[a].alive && graph.nodes[b].alive);
  assert(graph.nodes[a].shared.contains(b));
  MergeNode &into = graph.nodes[a], &gone = graph.nodes[b];
  const bool gone_is_larger = gone.area_m2 > into.area_m2;
  if (remember == Remember::kBoth)
    join_histories(into, gone);
  else if (gone_is_larger)
    into.history = gone.history;
  if (gone_is_larger) into.direction = gone.direction;
  into.area_m2 += gone.area_m2;
  into.cells.insert(into.cells.end(), gone.cells.begin(), gone.cells.end());
  into.shared.erase(b);
  for (const auto& [neighbour, length] : gone.shared) {
    if (neighbour == a) continue;
    MergeNode& third = graph.nodes[neighbour];
    third.shared.erase(b);
    third.shared[a] += length;
    into.shared[neighbour] += length;
  }
  gone.shared.clear();
  gone.alive = false;
}

std::vector<Subfield> subfields_of(const MergeGraph& graph) {
  std::vector<Subfield> out;
  for (const MergeNode& node : graph.nodes) {
    if (!node.alive) continue;
    Region parts;
    for (const std::size_t c : node.cells) parts.push_back(graph.cells[c].shape);
    for (Polygon& shape : parts.size() == 1 ? parts : dissolved(parts))
      out.push_back({std::move(shape), node.direction});
  }
  return out;
}

}  // namespace tramline
