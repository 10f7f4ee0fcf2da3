#include "tramline/coverage/tiles/tile_map.h"

namespace tramline::coverage {

Tile* TileMap::find(TileIndex index) {
  if (last_ != nullptr && last_->index == index) return last_;
  const auto found = by_index_.find(key(index));
  if (found == by_index_.end()) return nullptr;
  last_ = found->second;
  return last_;
}

const Tile* TileMap::find(TileIndex index) const {
  const auto found = by_index_.find(key(index));
  return found == by_index_.end() ? nullptr : found->second;
}

Tile& TileMap::at(TileIndex index, const FieldCells& field, CutScratch& scratch) {
  if (Tile* known = find(index)) return *known;
  Tile& tile = tiles_.emplace_back();
  tile.index = index;
  field.partition(index, tile.cells, scratch);
  by_index_.emplace(key(index), &tile);
  last_ = &tile;
  return tile;
}

}  // namespace tramline::coverage
