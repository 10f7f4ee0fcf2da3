#include "tramline/coverage/tiles/untouched_ground.h"

#include <algorithm>

namespace tramline::coverage {
namespace {

/// The four sides of a run of tiles of one row, columns first … last, counter-clockwise.
void append_run(std::int32_t row, std::int32_t first, std::int32_t last, std::int64_t side,
                std::vector<BorderEdge>& out) {
  const std::int64_t west = first * side, east = (last + std::int64_t{1}) * side;
  const std::int64_t south = row * side, north = (row + std::int64_t{1}) * side;
  out.push_back({false, row, west, east});
  out.push_back({true, last + 1, south, north});
  out.push_back({false, row + 1, east, west});
  out.push_back({true, first, north, south});
}

}  // namespace

UntouchedGround untouched_ground(const FieldCells& field, const std::vector<TileIndex>& touched,
                                 const TileFrame& frame) {
  UntouchedGround out;
  const std::vector<TileIndex> border = field.border_tiles();
  std::set_difference(border.begin(), border.end(), touched.begin(), touched.end(),
                      std::back_inserter(out.border_tiles));
  const std::int64_t side = frame.side;
  for (std::size_t i = 0; i + 1 < border.size(); ++i) {
    const TileIndex from = border[i], to = border[i + 1];
    if (from.row != to.row || from.column + 1 == to.column) continue;
    const GridPoint corner = frame.corner({from.column + 1, from.row});
    const double half = 0.5 * static_cast<double>(frame.side);
    if (!field.contains(static_cast<double>(corner.x) + half, static_cast<double>(corner.y) + half)) continue;
    std::int32_t first = from.column + 1;
    for (auto at = std::upper_bound(touched.begin(), touched.end(), from); at != touched.end() && *at < to;
         ++at) {
      if (at->column > first) append_run(from.row, first, at->column - 1, side, out.border);
      first = at->column + 1;
    }
    if (first < to.column) append_run(from.row, first, to.column - 1, side, out.border);
  }
  return out;
}

}  // namespace tramline::coverage
