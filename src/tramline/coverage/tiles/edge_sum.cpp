#include "tramline/coverage/tiles/edge_sum.h"

#include <bit>

namespace tramline::coverage {

EdgeSum::EdgeSum(std::size_t expected) : table_(std::bit_ceil(2 * expected + 8), 0) {
  edges_.reserve(expected);
}

void EdgeSum::add(TilePoint from, TilePoint to) {
  const bool turned = to < from;
  const TilePoint least = turned ? to : from, most = turned ? from : to;
  if (2 * edges_.size() >= table_.size()) {
    table_.assign(2 * table_.size(), 0);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      std::size_t slot = edge_hash(edges_[i].least, edges_[i].most) & (table_.size() - 1);
      while (table_[slot] != 0) slot = (slot + 1) & (table_.size() - 1);
      table_[slot] = static_cast<std::uint32_t>(i + 1);
    }
  }
  std::size_t slot = edge_hash(least, most) & (table_.size() - 1);
  for (; table_[slot] != 0; slot = (slot + 1) & (table_.size() - 1)) {
    Edge& edge = edges_[table_[slot] - 1];
    if (edge.least != least || edge.most != most) continue;
    edge.net += turned ? -1 : 1;
    return;
  }
  edges_.push_back({least, most, turned ? -1 : 1});
  table_[slot] = static_cast<std::uint32_t>(edges_.size());
}

}  // namespace tramline::coverage
