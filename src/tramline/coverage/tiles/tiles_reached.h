#pragma once
// The tiles that a convex piece or a segment reaches into.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tramline/coverage/tiles/tile_frame.h"

namespace tramline::coverage {

/// Calls `visit(TileIndex)` for the tiles of each row, from south to north and west to east, that the convex
/// hull of a closed convex ring (or of a segment) reaches into, grown by `margin` units (less than 0:
/// shrunk). `point(i)` gives the i-th of `count` points. O(rows · count + tiles).
template <class PointAt, class Visit>
void each_tile_reached(const TileFrame& frame, std::size_t count, PointAt point, std::int64_t margin,
                       Visit visit) {
  std::int64_t low = point(0).y, high = low, west = point(0).x, east = west;
  for (std::size_t i = 1; i < count; ++i) {
    low = std::min(low, point(i).y);
    high = std::max(high, point(i).y);
    west = std::min(west, point(i).x);
    east = std::max(east, point(i).x);
  }
  const auto first_row = frame.tile_at(low - margin), last_row = frame.tile_at(high + margin);
  const bool one_column = frame.tile_at(west - margin) == frame.tile_at(east + margin);
  for (std::int32_t row = first_row; row <= last_row; ++row) {
    if (!one_column && first_row != last_row) {
      const auto bottom = static_cast<double>(row * frame.side - margin);
      const auto top = static_cast<double>((row + std::int64_t{1}) * frame.side + margin);
      double least = INFINITY, most = -INFINITY;
      for (std::size_t i = 0; i < count; ++i) {
        const GridPoint a = point(i), b = point(i + 1 < count ? i + 1 : 0);
        const auto ax = static_cast<double>(a.x), ay = static_cast<double>(a.y);
        const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
        double from = 0, to = 1;
        if (dy != 0) {
          const double at_bottom = (bottom - ay) / dy, at_top = (top - ay) / dy;
          from = std::max(from, std::min(at_bottom, at_top));
          to = std::min(to, std::max(at_bottom, at_top));
        } else if (ay < bottom || ay > top) {
          continue;
        }
        if (from > to) continue;
        least = std::min({least, ax + from * dx, ax + to * dx});
        most = std::max({most, ax + from * dx, ax + to * dx});
      }
      if (least > most) continue;
      west = static_cast<std::int64_t>(std::floor(least));
      east = static_cast<std::int64_t>(std::ceil(most));
    }
    const auto last = frame.tile_at(east + margin);
    for (std::int32_t column = frame.tile_at(west - margin); column <= last; ++column)
      visit(TileIndex{column, row});
  }
}

}  // namespace tramline::coverage
