#pragma once
// Points on the integer grid of the exact engine, in the plane and within a tile.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tramline::coverage {

__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): only so is it an extension for GCC

/// A point of the plane, in units (tile_frame.h).
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend bool operator==(GridPoint a, GridPoint b) = default;
  /// By x and then by y.
  friend bool operator<(GridPoint a, GridPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

/// A point of a tile, in units from its south-west corner: 0 … 2^30.
struct TilePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(TilePoint a, TilePoint b) = default;
  /// By x and then by y.
  friend bool operator<(TilePoint a, TilePoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

/// A closed ring within a tile, counter-clockwise.
using TileRing = std::vector<TilePoint>;

/// Twice the area of triangle abc, positive where it runs counter-clockwise. Exact: 2^62 at most.
constexpr std::int64_t turn(TilePoint a, TilePoint b, TilePoint c) {
  return (static_cast<std::int64_t>(b.x) - a.x) * (static_cast<std::int64_t>(c.y) - a.y) -
         (static_cast<std::int64_t>(b.y) - a.y) * (static_cast<std::int64_t>(c.x) - a.x);
}
constexpr Int128 turn(GridPoint a, GridPoint b, GridPoint c) {
  return static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}

/// Both coordinates as one number.
constexpr std::uint64_t packed(TilePoint p) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x)) << 32 | static_cast<std::uint32_t>(p.y);
}

/// A hash of a directed edge.
constexpr std::size_t edge_hash(TilePoint from, TilePoint to) {
  std::uint64_t h = packed(from) * 0x9E3779B97F4A7C15ULL;
  h = (h ^ h >> 29 ^ packed(to)) * 0xBF58476D1CE4E5B9ULL;
  return static_cast<std::size_t>(h ^ h >> 32);
}

/// Floor of a / b for b > 0.
constexpr std::int64_t floor_divided(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace tramline::coverage
