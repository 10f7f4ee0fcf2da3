#include "tramline/coverage/tiles/convex_piece.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "tramline/coverage/tiles/tile_frame.h"

namespace tramline::coverage {
namespace {

/// Where side a → b crosses the line that a and b lie that far left of.
GridPoint crossing(GridPoint a, double a_inside, GridPoint b, double b_inside) {
  const double share = a_inside / (a_inside - b_inside);
  return {a.x + std::llrint(share * static_cast<double>(b.x - a.x)),
          a.y + std::llrint(share * static_cast<double>(b.y - a.y))};
}

/// The part of the piece where `side` times the distance is positive, bounded by `cut`.
void keep(const ConvexPiece& piece, const std::vector<double>& distance, double side, const GridLine& cut,
          ConvexPiece& out) {
  out.sides.clear();
  const std::size_t n = piece.sides.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const double here = side * distance[i], there = side * distance[j];
    const GridPoint from = piece.sides[i].from, to = piece.sides[j].from;
    if (here > kOnLine || (here >= -kOnLine && there >= -kOnLine)) {
      out.sides.push_back(piece.sides[i]);
    } else if (here >= -kOnLine) {
      out.sides.push_back({from, cut});
    }
    if (here > kOnLine && there < -kOnLine)
      out.sides.push_back({crossing(from, distance[i], to, distance[j]), cut});
    if (here < -kOnLine && there > kOnLine)
      out.sides.push_back({crossing(from, distance[i], to, distance[j]), piece.sides[i].line});
  }
  for (std::size_t i = 0; i < out.sides.size() && out.sides.size() > 1;) {
    const std::size_t next = i + 1 < out.sides.size() ? i + 1 : 0;
    if (out.sides[i].from == out.sides[next].from)
      out.sides.erase(out.sides.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  if (out.empty() || twice_area(out) <= 0) out.sides.clear();
}

}  // namespace

GridLine line_through(GridPoint from, GridPoint to) {
  assert(from != to);
  const auto dx = static_cast<double>(to.x - from.x), dy = static_cast<double>(to.y - from.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  return {from, -dy / length, dx / length};
}

ConvexPiece piece_of(const std::vector<GridPoint>& corners) {
  ConvexPiece out;
  out.sides.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.sides.push_back({corners[i], line_through(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0])});
  return out;
}

Int128 twice_area(const ConvexPiece& piece) {
  Int128 out = 0;
  for (std::size_t i = 2; i < piece.sides.size(); ++i)
    out += turn(piece.sides[0].from, piece.sides[i - 1].from, piece.sides[i].from);
  return out;
}

void split(const ConvexPiece& piece, const GridLine& line, ConvexPiece& inside, ConvexPiece& outside) {
  std::vector<double> distance;
  distance.reserve(piece.sides.size());
  for (const ConvexPiece::Side& side : piece.sides) distance.push_back(line.inside(side.from));
  const auto [least, most] = std::minmax_element(distance.begin(), distance.end());
  inside.sides.clear();
  outside.sides.clear();
  if (*most > kOnLine) keep(piece, distance, 1, line, inside);
  if (*least < -kOnLine) keep(piece, distance, -1, line.turned(), outside);
}

}  // namespace tramline::coverage
