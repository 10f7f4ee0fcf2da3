#include "tramline/coverage/ahead/need_ahead.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/geometry/polygon/convex_clip.h"

namespace tramline::coverage {
namespace {

/// Cross-sections closer together than this are one: cells end along common edges.
constexpr double kSame_m = 1e-9;

/// x ahead, y to the left.
class MachineFrame {
 public:
  explicit MachineFrame(const Motion& motion) : place_(motion.position), ahead_(motion.heading.unit()) {}

  Point seen(Point p) const {
    const Point d = p - place_;
    return {dot(d, ahead_), cross(ahead_, d)};
  }
  Point placed(Point p) const { return place_ + p.x * ahead_ + p.y * Point{-ahead_.y, ahead_.x}; }

 private:
  Point place_, ahead_;
};

Ring rectangle(double left_m, double right_m, double reach_m) {
  return {{0, right_m}, {reach_m, right_m}, {reach_m, left_m}, {0, left_m}};
}

/// An edge of a ring, walked ahead. The width of rings across the way is a sum over edges: those that their
/// ring lies left of run ahead, and count their distance to the left negative.
struct Edge {
  Point from;
  Point to;
  double sign = 0;

  double width(double x) const {
    const double t = std::clamp((x - from.x) / (to.x - from.x), 0.0, 1.0);
    return sign * ((1 - t) * from.y + t * to.y);
  }
};

std::vector<Edge> edges_of(const RingSet& rings) {
  std::vector<Edge> out;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (std::abs(b.x - a.x) < kSame_m) continue;
      out.push_back(a.x < b.x ? Edge{a, b, -1} : Edge{b, a, 1});
    }
  std::sort(out.begin(), out.end(), [](const Edge& a, const Edge& b) { return a.from.x < b.from.x; });
  return out;
}

/// Where edges begin and end.
std::vector<double> places_of(const std::vector<Edge>& edges, double reach_m) {
  std::vector<double> out{0, reach_m};
  for (const Edge& edge : edges) {
    out.push_back(std::clamp(edge.from.x, 0.0, reach_m));
    out.push_back(std::clamp(edge.to.x, 0.0, reach_m));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end(), [](double a, double b) { return b - a < kSame_m; }),
            out.end());
  return out;
}

/// Every stretch is summed from its own edges: rounding does not pile up.
Need need_of(const RingSet& rings, double width_m, double reach_m) {
  const std::vector<Edge> edges = edges_of(rings);
  const std::vector<double> positions = places_of(edges, reach_m);
  Need out;
  std::vector<const Edge*> met;
  auto next = edges.begin();
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    const double from = positions[i], to = positions[i + 1];
    for (; next != edges.end() && next->from.x < from + kSame_m; ++next) met.push_back(&*next);
    std::erase_if(met, [&](const Edge* edge) { return edge->to.x < to - kSame_m; });
    double width_from = 0, width_to = 0;
    for (const Edge* edge : met) {
      width_from += edge->width(from);
      width_to += edge->width(to);
    }
    out.push_back(
        {from, to, std::clamp(width_from / width_m, 0.0, 1.0), std::clamp(width_to / width_m, 0.0, 1.0)});
  }
  return out;
}

}  // namespace

double NeedStretch::at(double ahead_m) const {
  const double t = std::clamp((ahead_m - from_m) / (to_m - from_m), 0.0, 1.0);
  return (1 - t) * share_from + t * share_to;
}

std::vector<Need> need_ahead(const TileCoverage& coverage, const Motion& motion, const Boom& boom,
                             double reach_m) {
  assert(reach_m > 0);
  const MachineFrame frame(motion);
  double left_m = 0, right_m = 0;
  for (const Section& section : boom) {
    left_m = std::max(left_m, section.left_m);
    right_m = std::min(right_m, section.right_m);
  }
  RingSet open;
  if (left_m > right_m) {
    Ring swept = rectangle(left_m, right_m, reach_m);
    for (Point& p : swept) p = frame.placed(p);
    open = coverage.open_ground(swept);
    for (Ring& ring : open)
      for (Point& p : ring) p = frame.seen(p);
  }
  std::vector<Need> out;
  for (const Section& section : boom) {
    const double width_m = section.left_m - section.right_m;
    if (width_m > 0) {
      const ConvexSet strip = convex_set(rectangle(section.left_m, section.right_m, reach_m));
      out.push_back(need_of(clipped(open, strip), width_m, reach_m));
    } else {
      out.push_back({{0, reach_m, 0, 0}});
    }
  }
  return out;
}

}  // namespace tramline::coverage
