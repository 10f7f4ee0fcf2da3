#include "tramline/coverage/tiles/quad_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tramline::coverage {
namespace {

using GridCorners = std::array<GridPoint, 4>;

int side_of(GridPoint a, GridPoint b, GridPoint p) {
  const Int128 size = turn(a, b, p);
  return size > 0 ? 1 : size < 0 ? -1 : 0;
}

/// Where the insides of ab and cd cross.
std::optional<GridPoint> proper_crossing(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  if (side_of(a, b, c) * side_of(a, b, d) >= 0 || side_of(c, d, a) * side_of(c, d, b) >= 0)
    return std::nullopt;
  const auto from = static_cast<double>(turn(c, d, a)), to = static_cast<double>(turn(c, d, b));
  const double share = from / (from - to);
  return GridPoint{a.x + std::llrint(share * static_cast<double>(b.x - a.x)),
                   a.y + std::llrint(share * static_cast<double>(b.y - a.y))};
}

void append_triangle(GridPoint a, GridPoint b, GridPoint c, std::vector<ConvexPiece>& out) {
  const int side = side_of(a, b, c);
  if (side > 0) out.push_back(piece_of({a, b, c}));
  if (side < 0) out.push_back(piece_of({a, c, b}));
}

/// A quad that does not cross itself.
void append_simple(const GridCorners& q, std::vector<ConvexPiece>& out) {
  std::array<int, 4> side{};
  for (std::size_t i = 0; i < 4; ++i) side[i] = side_of(q[(i + 3) % 4], q[i], q[(i + 1) % 4]);
  const auto left = std::count(side.begin(), side.end(), 1);
  const auto right = std::count(side.begin(), side.end(), -1);
  if (left == 4) return out.push_back(piece_of({q[0], q[1], q[2], q[3]}));
  if (right == 4) return out.push_back(piece_of({q[0], q[3], q[2], q[1]}));
  // The diagonal from the corner that is bent the other way, or straight, lies within an arrow. With two of
  // a kind, corners coincide or all lie on a line.
  const int odd = left >= right ? -1 : 1;
  auto at = std::find(side.begin(), side.end(), odd);
  if (at == side.end()) at = std::find(side.begin(), side.end(), 0);
  const auto i = static_cast<std::size_t>(at - side.begin());
  append_triangle(q[i], q[(i + 1) % 4], q[(i + 2) % 4], out);
  append_triangle(q[i], q[(i + 2) % 4], q[(i + 3) % 4], out);
}

}  // namespace

void append_pieces(const Quad& quad, const TileFrame& frame, std::vector<ConvexPiece>& out) {
  GridCorners q;
  std::transform(quad.begin(), quad.end(), q.begin(), [&](Point p) { return frame.rounded(p); });
  if (const auto ends = proper_crossing(q[0], q[1], q[2], q[3])) {
    append_triangle(*ends, q[1], q[2], out);
    append_triangle(*ends, q[3], q[0], out);
  } else if (const auto sides = proper_crossing(q[1], q[2], q[3], q[0])) {
    append_triangle(q[0], q[1], *sides, out);
    append_triangle(*sides, q[2], q[3], out);
  } else {
    append_simple(q, out);
  }
}

}  // namespace tramline::coverage
