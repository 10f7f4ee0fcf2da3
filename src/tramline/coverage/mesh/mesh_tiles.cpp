#include "tramline/coverage/mesh/mesh_tiles.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "tramline/coverage/mesh/mesh_boolean.h"

namespace tramline::coverage {
namespace {

/// A row of the boundary of a square: its two ends, and what lies between them if that is boundary too.
MeshRow row_of_square(std::int32_t west, std::int32_t east, Corners first, Corners between, Corners last) {
  MeshRow out{{west, first}};
  if (between != kAllCorners)
    for (std::int32_t x = west + 1; x < east; ++x) out.push_back({x, between});
  out.push_back({east, last});
  return out;
}

/// The region of side × side corners of the grid whose least is (x, y). A mesh has its own place as its
/// south-western corner.
MeshRegion square_of_corners(std::int32_t x, std::int32_t y, int side) {
  MeshRegion out;
  const std::int32_t west = x - 1, east = x + side - 1;
  out.replace(y - 1, 0, 0, row_of_square(west, east, kNorthEast, kNorthEast | kNorthWest, kNorthWest));
  const MeshRow sides =
      row_of_square(west, east, kNorthEast | kSouthEast, kAllCorners, kNorthWest | kSouthWest);
  for (std::int32_t row = y; row < y + side - 1; ++row) out.replace(row, 0, 0, sides);
  out.replace(y + side - 1, 0, 0, row_of_square(west, east, kSouthEast, kSouthEast | kSouthWest, kSouthWest));
  return out;
}

}  // namespace

MeshTiles::MeshTiles(int side) : side_(side) { assert(side > 0); }

std::int32_t MeshTiles::tile_at(std::int32_t corner) const {
  return corner >= 0 ? corner / side_ : -((side_ - 1 - corner) / side_);
}

void MeshTiles::touch(const MeshRegion& changed) {
  constexpr auto kNone = std::numeric_limits<std::int32_t>::max();
  std::int32_t least = kNone, most = -kNone;
  for (int y = changed.first_row(); y < changed.end_row(); ++y) {
    // Corners of the grid at this y are the northern ones of the row below, or the southern ones of this.
    for (const auto row : {changed.row(y - 1), changed.row(y)}) {
      if (row.empty()) continue;
      least = std::min(least, row.front().x);
      most = std::max(most, row.back().x + 1);
    }
    const bool last_of_tile = y + 1 == changed.end_row() || tile_at(y + 1) != tile_at(y);
    if (!last_of_tile || least == kNone) continue;
    for (std::int32_t column = tile_at(least); column <= tile_at(most); ++column)
      changed_[{column, tile_at(y)}] = stamp_ + 1;
    touched_ = true;
    least = kNone;
    most = -kNone;
  }
}

void MeshTiles::end_step() {
  if (touched_) ++stamp_;
  touched_ = false;
}

std::vector<TileIndex> MeshTiles::changed_since(std::uint64_t stamp) const {
  std::vector<TileIndex> out;
  for (const auto& [tile, changed] : changed_)
    if (changed > stamp) out.push_back(tile);
  return out;
}

MeshRegion MeshTiles::part(const MeshRegion& region, TileIndex tile) const {
  return combined(region, square_of_corners(tile.column * side_, tile.row * side_, side_),
                  MeshOperation::kIntersection);
}

}  // namespace tramline::coverage
