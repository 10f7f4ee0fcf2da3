#include "tramline/check/measure/edge_runs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/check/measure/near_land.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

/// The land straight on from `end`, seen along `ahead`, to the boundary; nothing where that is too far off.
Region land_straight_on(Point end, Point ahead, Point inland, const Ring& outer, double depth_m) {
  constexpr double kDepths = 2;
  const Point side = end + depth_m * inland, run = kDepths * depth_m * ahead;
  const Polygon strip{{end, end + run, side + run, side}, {}};
  Region out;
  for (const Polygon& part : intersection({oriented(strip)}, {{outer, {}}})) {
    double first_m = std::numeric_limits<double>::infinity(), last_m = -first_m;
    for (const Point p : part.outer) {
      first_m = std::min(first_m, dot(p - end, ahead));
      last_m = std::max(last_m, dot(p - end, ahead));
    }
    if (first_m > 2 * kTouching_m) continue;
    if (last_m > kDepths * depth_m - 2 * kTouching_m) return {};
    out.push_back(part);
  }
  return out;
}

Point direction(Point from, Point to) { return (1 / distance(from, to)) * (to - from); }

/// Just inside beside the middle of an edge.
Point beside_middle(Point from, Point to) {
  constexpr double kBeside_m = 1e-3;
  return midpoint(from, to) + std::min(kBeside_m, distance(from, to)) * left_of(direction(from, to));
}

}  // namespace

int passes_round_field(const Plan& plan) {
  const std::vector<int>& by_edge = plan.headland.edge_passes;
  return by_edge.empty() ? plan.settings.headlands : passes_everywhere(by_edge);
}

int passes_along_edges(const Plan& plan) {
  return std::max(passes_round_field(plan), passes_anywhere(plan.headland.edge_passes));
}

std::vector<EdgeRun> edge_runs(const Plan& plan, int number) {
  const std::vector<int>& by_edge = plan.headland.edge_passes;
  const Ring& outer = plan.field.outer;
  assert(by_edge.empty() || by_edge.size() == outer.size());
  std::vector<EdgeRun> out;
  const auto bare = std::find_if(by_edge.begin(), by_edge.end(), [number](int n) { return n < number; });
  if (bare == by_edge.end()) return out;
  const auto start = static_cast<std::size_t>(bare - by_edge.begin());
  bool open = false;
  for (std::size_t i = start; i < start + outer.size(); ++i) {
    const std::size_t edge = i % outer.size();
    const Point to = outer[(edge + 1) % outer.size()];
    if (by_edge[edge] < number) {
      open = false;
      continue;
    }
    if (!open) out.push_back({outer[edge]});
    open = true;
    if (distance(out.back().back(), to) > kTouching_m) out.back().push_back(to);
  }
  std::erase_if(out, [](const EdgeRun& run) { return run.size() < 2; });
  return out;
}

Region land_beside(const EdgeRun& run, const Ring& outer, double depth_m) {
  Region out = land_near_line(run, depth_m);
  const std::size_t last = run.size() - 1;
  const Point first_along = direction(run[0], run[1]), last_along = direction(run[last - 1], run[last]);
  for (const Region& beyond :
       {land_straight_on(run.front(), -1.0 * first_along, left_of(first_along), outer, depth_m),
        land_straight_on(run.back(), last_along, left_of(last_along), outer, depth_m)})
    out.insert(out.end(), beyond.begin(), beyond.end());
  out = intersection(unite(out), {{outer, {}}});
  std::erase_if(out, [&run](const Polygon& part) {
    for (std::size_t i = 1; i < run.size(); ++i)
      if (contains(part, beside_middle(run[i - 1], run[i]))) return false;
    return true;
  });
  return out;
}

double arcs_beside_m(const EdgeRun& run, double depth_m) {
  double sum = 0;
  for (std::size_t i = 2; i < run.size(); ++i) {
    const Point before = run[i - 1] - run[i - 2], behind = run[i] - run[i - 1];
    sum += depth_m * std::max(0.0, -std::atan2(cross(before, behind), dot(before, behind)));
  }
  return sum;
}

double distance_from(const EdgeRun& run, const Path& path) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < run.size(); ++i)
    for (const PathSegment& segment : path)
      out = std::min(out, distance_to_edge(segment, run[i - 1], run[i]));
  return out;
}

}  // namespace tramline::check
