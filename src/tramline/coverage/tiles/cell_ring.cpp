#include "tramline/coverage/tiles/cell_ring.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace tramline::coverage {
namespace {

constexpr int kBoxShift = 15;

std::uint16_t coarse_units(std::int64_t coordinate, std::int64_t side) {
  return static_cast<std::uint16_t>(std::clamp<std::int64_t>(coordinate, 0, side) >> kBoxShift);
}

bool same_place(TilePoint p, double x, double y) {
  return std::abs(p.x - x) <= kSamePlace && std::abs(p.y - y) <= kSamePlace;
}

bool on_border(TilePoint p, std::int64_t side) {
  constexpr auto kNear = static_cast<std::int64_t>(kSamePlace);
  return p.x <= kNear || p.y <= kNear || p.x >= side - kNear || p.y >= side - kNear;
}

/// Rounded. Precondition: not negative.
std::int32_t nearest(double value) {
  assert(value >= 0);
  constexpr double kHalf = 0.5;  // and cut off: lround is a call, and this is the innermost loop
  return static_cast<std::int32_t>(value + kHalf);
}

std::int32_t between(double value, std::int32_t least, std::int32_t most) {
  return nearest(std::clamp<double>(value, least, most));
}

TilePoint crossing(TilePoint a, double a_inside, TilePoint b, double b_inside, const TileLine& line,
                   std::int64_t side) {
  if (b < a) {
    std::swap(a, b);
    std::swap(a_inside, b_inside);
  }
  // On the border of the tile the line itself says where, to the tile on the other side just the same.
  if (a.x == b.x && line.ny != 0 && (a.x == 0 || a.x == side))
    return {a.x, between(-(line.nx * a.x + line.offset) / line.ny, a.y, b.y)};
  if (a.y == b.y && line.nx != 0 && (a.y == 0 || a.y == side))
    return {between(-(line.ny * a.y + line.offset) / line.nx, a.x, b.x), a.y};
  const double share = a_inside / (a_inside - b_inside);
  const double x = a.x + share * (static_cast<double>(b.x) - a.x);
  const double y = a.y + share * (static_cast<double>(b.y) - a.y);
  const TilePoint p{nearest(x), nearest(y)};
  if (on_border(p, side)) return p;
  if (same_place(p, line.from_x, line.from_y))
    return {static_cast<std::int32_t>(line.from_x), static_cast<std::int32_t>(line.from_y)};
  if (same_place(p, line.to_x, line.to_y))
    return {static_cast<std::int32_t>(line.to_x), static_cast<std::int32_t>(line.to_y)};
  return p;
}

void append(TilePoint p, TileRing& ring) {
  if (ring.empty() || ring.back() != p) ring.push_back(p);
}

void finish(TileRing& ring) {
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  if (ring.size() < 3 || twice_area(ring) <= 0) ring.clear();
}

}  // namespace

std::int64_t twice_area(const TilePoint* points, std::size_t count) {
  std::int64_t out = 0;
  for (std::size_t i = 2; i < count; ++i) out += turn(points[0], points[i - 1], points[i]);
  return out;
}

CellBox box_of(const TileRing& ring) {
  TilePoint least = ring[0], most = ring[0];
  for (const TilePoint p : ring) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
  return {static_cast<std::uint16_t>(least.x >> kBoxShift), static_cast<std::uint16_t>(least.y >> kBoxShift),
          static_cast<std::uint16_t>(most.x >> kBoxShift), static_cast<std::uint16_t>(most.y >> kBoxShift)};
}

TileLine tile_line(const GridLine& line, GridPoint from, GridPoint to, GridPoint corner) {
  return {line.nx,
          line.ny,
          line.inside(corner),
          static_cast<double>(from.x - corner.x),
          static_cast<double>(from.y - corner.y),
          static_cast<double>(to.x - corner.x),
          static_cast<double>(to.y - corner.y)};
}

void see(const ConvexPiece& piece, GridPoint corner, std::int64_t side, TilePiece& out) {
  out.lines.clear();
  GridPoint least = piece.sides[0].from, most = least;
  for (std::size_t i = 0; i < piece.sides.size(); ++i) {
    const ConvexPiece::Side& here = piece.sides[i];
    const GridPoint to = piece.sides[i + 1 < piece.sides.size() ? i + 1 : 0].from;
    out.lines.push_back(tile_line(here.line, here.from, to, corner));
    least = {std::min(least.x, here.from.x), std::min(least.y, here.from.y)};
    most = {std::max(most.x, here.from.x), std::max(most.y, here.from.y)};
  }
  const auto squared = [](const TileLine& l) {
    return (l.to_x - l.from_x) * (l.to_x - l.from_x) + (l.to_y - l.from_y) * (l.to_y - l.from_y);
  };
  for (std::size_t i = 1; i < out.lines.size(); ++i)
    for (std::size_t k = i; k > 0 && squared(out.lines[k]) > squared(out.lines[k - 1]); --k)
      std::swap(out.lines[k], out.lines[k - 1]);
  out.box = {coarse_units(least.x - corner.x, side), coarse_units(least.y - corner.y, side),
             coarse_units(most.x - corner.x, side), coarse_units(most.y - corner.y, side)};
}

void split(const TileRing& ring, const std::vector<double>& distance, const TileLine& line, std::int64_t side,
           TileRing& inside, TileRing& outside) {
  inside.clear();
  outside.clear();
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const double here = distance[i], there = distance[j];
    if (here >= -kOnLine) append(ring[i], inside);
    if (here <= kOnLine) append(ring[i], outside);
    if ((here > kOnLine && there < -kOnLine) || (here < -kOnLine && there > kOnLine)) {
      const TilePoint p = crossing(ring[i], here, ring[j], there, line, side);
      append(p, inside);
      append(p, outside);
    }
  }
  finish(inside);
  finish(outside);
}

}  // namespace tramline::coverage
