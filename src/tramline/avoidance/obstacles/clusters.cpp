#include "tramline/avoidance/obstacles/clusters.h"

#include <numeric>

#include "tramline/avoidance/obstacles/bridge.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

using Index = std::size_t;

struct ClosePair {
  Index a, b;
};

std::vector<ClosePair> close_pairs(const Region& obstacles, double width_m) {
  std::vector<ClosePair> pairs;
  for (Index a = 0; a < obstacles.size(); ++a)
    for (Index b = a + 1; b < obstacles.size(); ++b) {
      if (!intersects(bounds(obstacles[a]).grown(width_m), bounds(obstacles[b]))) continue;
      if (distance_between({obstacles[a]}, {obstacles[b]}) < width_m) pairs.push_back({a, b});
    }
  return pairs;
}

void append(Region parts, Region& to) {
  for (Polygon& part : parts) to.push_back(std::move(part));
}

/// The first member of each obstacle's group.
std::vector<Index> group_of_each(Index count, const std::vector<ClosePair>& pairs) {
  std::vector<Index> first(count);
  std::iota(first.begin(), first.end(), Index{0});
  const auto root = [&first](Index i) {
    while (first[i] != i) i = first[i];
    return i;
  };
  for (const ClosePair& pair : pairs) {
    const Index a = root(pair.a), b = root(pair.b);
    first[std::max(a, b)] = std::min(a, b);
  }
  for (Index i = 0; i < count; ++i) first[i] = root(i);
  return first;
}

}  // namespace

std::vector<Cluster> clusters(const Region& obstacles, double width_m) {
  const std::vector<ClosePair> pairs = close_pairs(obstacles, width_m);
  const std::vector<Index> first = group_of_each(obstacles.size(), pairs);
  std::vector<Cluster> by_first(obstacles.size());
  for (Index i = 0; i < obstacles.size(); ++i) by_first[first[i]].obstacles.push_back(obstacles[i]);
  for (const ClosePair& pair : pairs) {
    Region& given_up = by_first[first[pair.a]].given_up;
    // From both sides: between two corners a single bridge would end in a point.
    append(bridge(obstacles[pair.a].outer, {obstacles[pair.b]}, width_m), given_up);
    append(bridge(obstacles[pair.b].outer, {obstacles[pair.a]}, width_m), given_up);
  }
  std::erase_if(by_first, [](const Cluster& cluster) { return cluster.obstacles.empty(); });
  return by_first;
}

}  // namespace tramline
