#pragma once
// The division of the plane into tiles, and the grid of all coordinates of the exact engine.

#include <cmath>
#include <cstdint>

#include "tramline/coverage/tiles/grid_point.h"
#include "tramline/geometry/point.h"

namespace tramline::coverage {

/// Least and largest side of a tile, m. A tile has up to 2^30 units a side, and units are finer than 1 µm.
inline constexpr double kLeastTile_m = 0.25;
inline constexpr double kLargestTile_m = 512;

// Distances that count as zero, in units. Crossings are rounded by 0.7 at most, and vertices lost by merging
// cells lay no further than kStraight from the remaining edge.
/// A vertex no further from a line than this lies on it.
inline constexpr double kOnLine = 4;
/// A crossing this close, in x and y, to a corner of the cutting piece is that corner.
inline constexpr double kSamePlace = 2;
/// A corner of merged cells no further than this from the line between its neighbours is removed.
inline constexpr double kStraight = 1;

struct TileIndex {
  std::int32_t column = 0;  ///< to the east
  std::int32_t row = 0;     ///< to the north

  friend bool operator==(TileIndex a, TileIndex b) = default;
  /// By row and then by column.
  friend bool operator<(TileIndex a, TileIndex b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  }
};

/// Frame: units count from the origin of the local frame.
struct TileFrame {
  double unit_m = 0;      ///< a power of two
  std::int64_t side = 0;  ///< of a tile, in units

  GridPoint rounded(Point p) const { return {nearest(p.x / unit_m), nearest(p.y / unit_m)}; }
  double area_m2(Int128 twice) const { return static_cast<double>(twice) * 0.5 * unit_m * unit_m; }

  std::int32_t tile_at(std::int64_t coordinate) const {
    return static_cast<std::int32_t>(floor_divided(coordinate, side));
  }
  GridPoint corner(TileIndex tile) const { return {tile.column * side, tile.row * side}; }

 private:
  static std::int64_t nearest(double value) { return std::llrint(value); }
};

/// Throws bad input where the side is not within kLeastTile_m … kLargestTile_m. It is rounded to whole
/// units.
TileFrame tile_frame(double tile_m);

}  // namespace tramline::coverage
