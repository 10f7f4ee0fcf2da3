#include "tramline/coverage/cell_store.h"

#include <algorithm>
#include <utility>

namespace tramline::coverage {

void CellStore::add(const TileRing& ring, CellState state) {
  boxes_.push_back(box_of(ring));
  heads_.push_back(
      {static_cast<std::uint32_t>(points_.size()), static_cast<std::uint16_t>(ring.size()), state});
  points_.insert(points_.end(), ring.begin(), ring.end());
}

void CellStore::replace(std::size_t cell, const TileRing& ring, CellState state) {
  Head& head = heads_[cell];
  boxes_[cell] = box_of(ring);
  unused_ += head.count;
  if (ring.size() <= head.count) {
    std::copy(ring.begin(), ring.end(), points_.begin() + head.first);
    unused_ -= ring.size();
  } else {
    head.first = static_cast<std::uint32_t>(points_.size());
    points_.insert(points_.end(), ring.begin(), ring.end());
  }
  head.count = static_cast<std::uint16_t>(ring.size());
  head.state = state;
  constexpr std::size_t kFewPoints = 256;
  if (unused_ > kFewPoints && 2 * unused_ > points_.size()) squeeze();
}

void CellStore::keep(const std::vector<bool>& kept) {
  std::size_t to = 0;
  for (std::size_t from = 0; from < heads_.size(); ++from) {
    if (!kept[from]) continue;
    heads_[to] = heads_[from];
    boxes_[to++] = boxes_[from];
  }
  heads_.resize(to);
  boxes_.resize(to);
  heads_.shrink_to_fit();
  boxes_.shrink_to_fit();
  squeeze();
}

void CellStore::squeeze() {
  std::size_t count = 0;
  for (const Head& head : heads_) count += head.count;
  std::vector<TilePoint> points;
  points.reserve(count);
  for (Head& head : heads_) {
    const auto first = points_.begin() + head.first;
    head.first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), first, first + head.count);
  }
  points_ = std::move(points);
  unused_ = 0;
}

std::size_t CellStore::bytes() const {
  return sizeof(CellStore) + boxes_.capacity() * sizeof(CellBox) + heads_.capacity() * sizeof(Head) +
         points_.capacity() * sizeof(TilePoint);
}

}  // namespace tramline::coverage
