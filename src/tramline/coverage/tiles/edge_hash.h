#pragma once
// A hash of directed edges, for the tables of edges in this folder.

#include <cstddef>
#include <cstdint>

#include "tramline/coverage/tiles/grid_point.h"

namespace tramline::coverage {

/// Both coordinates as one number.
constexpr std::uint64_t packed(TilePoint p) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x)) << 32 | static_cast<std::uint32_t>(p.y);
}

constexpr std::size_t edge_hash(TilePoint from, TilePoint to) {
  std::uint64_t h = packed(from) * 0x9E3779B97F4A7C15ULL;
  h = (h ^ h >> 29 ^ packed(to)) * 0xBF58476D1CE4E5B9ULL;
  return static_cast<std::size_t>(h ^ h >> 32);
}

}  // namespace tramline::coverage
