#include "tramline/coverage/tiles/cell_store.h"

#include <algorithm>
#include <utility>

namespace tramline::coverage {
namespace {

std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 8) & 0x00FF00FFU;
  bits = (bits | bits << 4) & 0x0F0F0F0FU;
  bits = (bits | bits << 2) & 0x33333333U;
  return (bits | bits << 1) & 0x55555555U;
}

/// Places along a Z-order curve: what is close along it is close in the plane.
std::uint32_t position_key(const CellBox& box) {
  const auto x = (std::uint32_t{box.min_x} + box.max_x) / 2, y = (std::uint32_t{box.min_y} + box.max_y) / 2;
  return spread(x) | spread(y) << 1;
}

/// Room for `more`, a quarter more than needed where there is none: there are many tiles, most of them done
/// with, and doubling would leave each with room for nothing.
template <class T>
void make_room(std::vector<T>& values, std::size_t more) {
  const std::size_t needed = values.size() + more;
  if (needed > values.capacity()) values.reserve(needed + needed / 4);
}

}  // namespace

void CellStore::add(const TileRing& ring, CellState state) {
  make_room(boxes_, 1);
  make_room(heads_, 1);
  make_room(points_, ring.size());
  boxes_.push_back(box_of(ring));
  heads_.push_back(
      {static_cast<std::uint32_t>(points_.size()), static_cast<std::uint16_t>(ring.size()), state});
  points_.insert(points_.end(), ring.begin(), ring.end());
  extend_block(boxes_.size() - 1);
}

void CellStore::extend_block(std::size_t cell) {
  if (cell / kBlock == blocks_.size())
    blocks_.push_back(boxes_[cell]);
  else
    blocks_[cell / kBlock].extend(boxes_[cell]);
}

void CellStore::replace(std::size_t cell, const TileRing& ring, CellState state) {
  Head& head = heads_[cell];
  boxes_[cell] = box_of(ring);
  extend_block(cell);
  unused_ += head.count;
  if (ring.size() <= head.count) {
    std::copy(ring.begin(), ring.end(), points_.begin() + head.first);
    unused_ -= ring.size();
  } else {
    head.first = static_cast<std::uint32_t>(points_.size());
    make_room(points_, ring.size());
    points_.insert(points_.end(), ring.begin(), ring.end());
  }
  head.count = static_cast<std::uint16_t>(ring.size());
  head.state = state;
  constexpr std::size_t kFewPoints = 256;
  if (unused_ > kFewPoints && 2 * unused_ > points_.size()) squeeze();
}

void CellStore::keep(const std::vector<bool>& kept) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // place, cell
  for (std::size_t c = 0; c < heads_.size(); ++c)
    if (kept[c]) order.emplace_back(position_key(boxes_[c]), static_cast<std::uint32_t>(c));
  std::sort(order.begin(), order.end());
  std::vector<Head> heads;
  std::vector<CellBox> boxes;
  heads.reserve(order.size());
  boxes.reserve(order.size());
  for (const auto& [key, cell] : order) {
    heads.push_back(heads_[cell]);
    boxes.push_back(boxes_[cell]);
  }
  heads_ = std::move(heads);
  boxes_ = std::move(boxes);
  blocks_.clear();
  for (std::size_t c = 0; c < boxes_.size(); ++c) extend_block(c);
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
  return sizeof(CellStore) + (boxes_.capacity() + blocks_.capacity()) * sizeof(CellBox) +
         heads_.capacity() * sizeof(Head) + points_.capacity() * sizeof(TilePoint);
}

}  // namespace tramline::coverage
