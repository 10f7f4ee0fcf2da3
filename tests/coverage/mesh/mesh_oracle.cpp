#include "coverage/mesh/mesh_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tramline::coverage::testing_meshes {
namespace {

/// Times that the ring winds round a place, counter-clockwise: crossings of the ray towards growing x.
int winding(const Ring& ring, long double x, long double y) {
  int out = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > y) == (b.y > y)) continue;
    const long double share = (y - a.y) / (static_cast<long double>(b.y) - a.y);
    if (a.x + share * (static_cast<long double>(b.x) - a.x) > x) out += b.y > a.y ? 1 : -1;
  }
  return out;
}

unsigned expected_corners(const CornerSet& set, int x, int y) {
  return (set.at(x + 1, y + 1) ? kNorthEast : 0U) | (set.at(x, y + 1) ? kNorthWest : 0U) |
         (set.at(x, y) ? kSouthWest : 0U) | (set.at(x + 1, y) ? kSouthEast : 0U);
}

}  // namespace

std::int64_t CornerSet::count() const {
  return std::count_if(inside_.begin(), inside_.end(), [](char inside) { return inside != 0; });
}

CornerSet corners_of(const std::vector<Ring>& rings, int low, int high) {
  CornerSet out(low, high);
  for (int y = low; y <= high; ++y)
    for (int x = low; x <= high; ++x) {
      int times = 0;
      for (const Ring& ring : rings) times += winding(ring, x - 1e-13L, y - 1e-9L);
      out.set(x, y, times != 0);
    }
  return out;
}

CornerSet together(const CornerSet& a, const CornerSet& b, const std::function<bool(bool, bool)>& operation) {
  CornerSet out(a.low(), a.high());
  for (int y = a.low(); y <= a.high(); ++y)
    for (int x = a.low(); x <= a.high(); ++x) out.set(x, y, operation(a.at(x, y), b.at(x, y)));
  return out;
}

std::string difference(const MeshRegion& region, const CornerSet& expected) {
  if (region.corners_inside() != expected.count())
    return fmt::format("{} corners instead of {}", region.corners_inside(), expected.count());
  std::size_t meshes = 0;
  for (int y = expected.low(); y < expected.high(); ++y) {
    const auto row = region.row(y);
    for (int x = expected.low(); x < expected.high(); ++x) {
      const unsigned corners = expected_corners(expected, x, y);
      const bool on_boundary = corners != kNoCorner && corners != kAllCorners;
      const auto found =
          std::find_if(row.begin(), row.end(), [&](const BoundaryMesh& m) { return m.x == x; });
      if ((found != row.end()) != on_boundary || (on_boundary && found->inside != corners))
        return fmt::format("mesh ({}, {}) should have corners {}, and has {}", x, y, corners,
                           found == row.end() ? -1 : int{found->inside});
      if (on_boundary) ++meshes;
    }
  }
  if (meshes != region.meshes()) return fmt::format("{} meshes instead of {}", region.meshes(), meshes);
  return {};
}

Ring random_star(std::mt19937_64& random, Point middle, double least, double most, double step) {
  const int corners = std::uniform_int_distribution(3, 14)(random);
  std::uniform_real_distribution<double> reach(least, most), turn(0.2, 1.0);
  std::vector<double> turns;
  double sum = 0;
  for (int i = 0; i < corners; ++i) sum += turns.emplace_back(turn(random));
  double angle = 2 * std::numbers::pi * turn(random);
  Ring out;
  for (const double part : turns) {
    angle += 2 * std::numbers::pi * part / sum;
    const double r = reach(random);
    out.push_back({step * std::round((middle.x + r * std::cos(angle)) / step),
                   step * std::round((middle.y + r * std::sin(angle)) / step)});
  }
  return out;
}

std::vector<Ring> random_rings(std::mt19937_64& random, double most, double step) {
  std::uniform_real_distribution<double> off(-0.3 * most, 0.3 * most);
  const auto star = [&](double least, double reach) {
    const Point middle{off(random), off(random)};
    return random_star(random, middle, least, reach, step);
  };
  std::vector<Ring> out{star(0.4 * most, most)};
  const int holes = std::uniform_int_distribution(0, 3)(random);
  for (int i = 0; i < holes; ++i) out.push_back(reversed(star(0.03 * most, 0.25 * most)));
  return out;
}

}  // namespace tramline::coverage::testing_meshes
