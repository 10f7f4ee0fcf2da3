#include "coverage/tiles/literal_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace tramline::testing {
namespace {

struct Edge {
  Point low;
  Point high;
  int step = -1;  ///< -1: the field's
  int quad = -1;  ///< over all steps

  double x_at(double y) const { return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x); }
};

void append(Point a, Point b, int step, int quad, std::vector<Edge>& out) {
  if (a.y < b.y) out.push_back({a, b, step, quad});
  if (b.y < a.y) out.push_back({b, a, step, quad});
}

std::vector<Edge> edges_of(const Region& field, const std::vector<coverage::WorkedStep>& steps,
                           Point origin) {
  std::vector<Edge> out;
  for (const Ring& ring : rings_of(field))
    for (std::size_t i = 0; i < ring.size(); ++i)
      append(ring[i] - origin, ring[(i + 1) % ring.size()] - origin, -1, -1, out);
  int quad = 0;
  for (std::size_t s = 0; s < steps.size(); ++s)
    for (const coverage::Quad& q : steps[s].quads) {
      for (std::size_t i = 0; i < 4; ++i)
        append(q[i] - origin, q[(i + 1) % 4] - origin, static_cast<int>(s), quad, out);
      ++quad;
    }
  return out;
}

void append_crossing(const Edge& a, const Edge& b, std::vector<double>& heights) {
  const Point r = a.high - a.low, s = b.high - b.low;
  const double both = cross(r, s);
  if (both == 0) return;
  const double t = cross(b.low - a.low, s) / both, u = cross(b.low - a.low, r) / both;
  if (t > 0 && t < 1 && u > 0 && u < 1) heights.push_back(a.low.y + t * r.y);
}

/// The history of one bit of ground: the quads that work it, in order.
struct History {
  int times = 0;
  bool repeated = false;
};

History history(const std::vector<int>& worked_by, const std::vector<coverage::WorkedStep>& steps) {
  History out;
  out.times = static_cast<int>(worked_by.size());
  for (const int now : worked_by) {
    const coverage::WorkedStep& step = steps[static_cast<std::size_t>(now)];
    bool before = false, own = false;
    for (const int then : worked_by) {
      if (then >= now) continue;
      const coverage::WorkedStep& earlier = steps[static_cast<std::size_t>(then)];
      before = true;
      own = own || (earlier.run == step.run && earlier.travel_m >= step.travel_m - step.reach_m);
    }
    out.repeated = out.repeated || (before && !own);
  }
  return out;
}

void count(const History& ground, bool in_field, double area, CoverageAreas& out) {
  if (ground.times == 0) {
    if (in_field) out.missed_m2 += area;
    return;
  }
  out.covered_m2 += area;
  (in_field ? out.covered_inside_m2 : out.outside_m2) += area;
  if (ground.repeated) out.repeated_m2 += area;
  if (!ground.repeated && ground.times > 1) out.sliver_m2 += area;
  out.worked_times_m2[static_cast<std::size_t>(std::min(ground.times, kMostCounted))] += area;
}

}  // namespace

CoverageAreas literal_coverage(const Region& field, const std::vector<coverage::WorkedStep>& steps) {
  Point origin;
  if (!field.empty()) origin = field[0].outer[0];
  for (const coverage::WorkedStep& step : steps)
    if (!step.quads.empty()) origin = step.quads[0][0];
  const std::vector<Edge> edges = edges_of(field, steps, origin);
  std::vector<double> heights;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    heights.push_back(edges[i].low.y);
    heights.push_back(edges[i].high.y);
    for (std::size_t j = 0; j < i; ++j) append_crossing(edges[i], edges[j], heights);
  }
  std::sort(heights.begin(), heights.end());
  CoverageAreas out;
  std::vector<std::pair<double, const Edge*>> across;
  std::map<int, int> inside;  // quads, and their steps
  std::vector<int> worked_by;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double thickness = heights[i + 1] - heights[i], y = 0.5 * (heights[i] + heights[i + 1]);
    if (!(thickness > 0)) continue;
    across.clear();
    for (const Edge& edge : edges)
      if (edge.low.y < y && edge.high.y > y) across.emplace_back(edge.x_at(y), &edge);
    std::sort(across.begin(), across.end());
    bool in_field = false;
    inside.clear();
    for (std::size_t k = 0; k + 1 < across.size(); ++k) {
      const Edge& edge = *across[k].second;
      if (edge.step < 0)
        in_field = !in_field;
      else if (inside.erase(edge.quad) == 0)
        inside.emplace(edge.quad, edge.step);
      const double width = across[k + 1].first - across[k].first;
      if (!(width > 0)) continue;
      worked_by.clear();
      for (const auto& [quad, step] : inside) worked_by.push_back(step);
      count(history(worked_by, steps), in_field, width * thickness, out);
    }
  }
  out.worked_times_m2[0] = out.missed_m2;
  return out;
}

}  // namespace tramline::testing
