#include "tramline/headland/edges/chain_ground.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

Point inland_of(Point from, Point to) { return (1 / distance(from, to)) * left_of(to - from); }

Polygon strip_along(Point from, Point to, double depth_m) {
  const Point across = depth_m * inland_of(from, to);
  return {{from, to, to + across, from + across}, {}};
}

/// Between the strips of two edges, about the corner where the chain turns to the right.
Polygon fan_about(Point before, Point corner, Point behind, double depth_m) {
  const Point first = inland_of(before, corner), last = inland_of(corner, behind);
  const Path arc{{corner + depth_m * first, corner + depth_m * last, -1 / depth_m}};
  Ring out = chords(arc, kBodySagitta);
  std::reverse(out.begin(), out.end());
  out.push_back(corner);
  return {out, {}};
}

/// The part of a strip straight on beyond an end that lies in the field and adjoins the chain's own strip;
/// `ending` becomes kFlat where that goes on for more than twice the depth, and nothing is returned.
Region straight_on(const ChainEnd& end, const Ring& outer, double depth_m, ChainEnding& ending) {
  constexpr double kFarthest = 2;
  const Point far = kFarthest * depth_m * end.ahead, across = depth_m * end.inland;
  Ring box{end.at, end.at + far, end.at + far + across, end.at + across};
  if (signed_area(box) < 0) box = reversed(box);
  Region out = intersection({{box, {}}}, {{outer, {}}});
  const auto along = [&](Point p) { return dot(p - end.at, end.ahead); };
  std::erase_if(out, [&](const Polygon& part) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point p : part.outer) nearest = std::min(nearest, along(p));
    return nearest > kSamePlace_m + kGridSize;
  });
  const bool goes_on = std::any_of(out.begin(), out.end(), [&](const Polygon& part) {
    return std::any_of(part.outer.begin(), part.outer.end(),
                       [&](Point p) { return along(p) > kFarthest * depth_m - kSamePlace_m - kGridSize; });
  });
  ending = goes_on ? ChainEnding::kFlat : ChainEnding::kAtBoundary;
  return goes_on ? Region{} : out;
}

/// Whether land lies beside an edge of the chain.
bool adjoins(const Polygon& land, const EdgeChain& chain) {
  constexpr double kBesideEdge_m = 1e-3;
  const Box box = bounds(land).grown(kBesideEdge_m);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Point beside =
        midpoint(chain[i], chain[i + 1]) +
        std::min(kBesideEdge_m, distance(chain[i], chain[i + 1])) * inland_of(chain[i], chain[i + 1]);
    if (intersects(box, bounds(beside, beside)) && contains(land, beside)) return true;
  }
  return false;
}

}  // namespace

ChainGround ground_along(const EdgeChain& chain, const Ring& outer, double depth_m) {
  assert(chain.size() > 1 && depth_m > 0);
  ChainGround out;
  Region parts = straight_on(first_end(chain), outer, depth_m, out.first);
  const Region beyond_last = straight_on(last_end(chain), outer, depth_m, out.last);
  parts.insert(parts.end(), beyond_last.begin(), beyond_last.end());
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    parts.push_back(strip_along(chain[i], chain[i + 1], depth_m));
    if (i == 0) continue;
    const Point before = chain[i] - chain[i - 1], behind = chain[i + 1] - chain[i];
    if (std::atan2(cross(before, behind), dot(before, behind)) < -kStraightOn_rad)
      parts.push_back(fan_about(chain[i - 1], chain[i], chain[i + 1], depth_m));
  }
  out.land = intersection(unite(parts), {{outer, {}}});
  std::erase_if(out.land, [&](const Polygon& part) { return !adjoins(part, chain); });
  return out;
}

}  // namespace tramline
