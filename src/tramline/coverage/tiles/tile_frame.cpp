#include "tramline/coverage/tiles/tile_frame.h"

#include <fmt/format.h>
#include <cmath>

#include "tramline/geometry/error.h"

namespace tramline::coverage {

TileFrame tile_frame(double tile_m) {
  if (!(tile_m >= kLeastTile_m && tile_m <= kLargestTile_m))
    throw bad_input(
        fmt::format("the side of a tile must be {} to {} m, not {}", kLeastTile_m, kLargestTile_m, tile_m));
  constexpr int kBits = 30;
  TileFrame out;
  out.unit_m = std::ldexp(1, static_cast<int>(std::ceil(std::log2(tile_m))) - kBits);
  out.side = std::llround(tile_m / out.unit_m);
  return out;
}

}  // namespace tramline::coverage
