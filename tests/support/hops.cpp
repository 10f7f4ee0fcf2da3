#include "support/hops.h"

#include <algorithm>
#include <limits>

namespace tramline::testing_support {
namespace {

/// How much of the straight line from a to b lies inside the polygon, m.
double inside_m(const Polygon& polygon, Point a, Point b) {
  std::vector<double> places{0, 1};
  for (const Ring& ring : rings_of({polygon}))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point p = ring[i], q = ring[(i + 1) % ring.size()];
      const double parallel = cross(b - a, q - p);
      if (parallel == 0) continue;
      const double along = cross(p - a, q - p) / parallel, beside = cross(p - a, b - a) / parallel;
      if (along > 0 && along < 1 && beside >= 0 && beside <= 1) places.push_back(along);
    }
  std::sort(places.begin(), places.end());
  double share = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (contains(polygon, a + 0.5 * (places[i - 1] + places[i]) * (b - a)))
      share += places[i] - places[i - 1];
  return share * distance(a, b);
}

double off_edge_m(const Ring& ring, Point p) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], edge = ring[(i + 1) % ring.size()] - a;
    const double along = std::clamp(dot(p - a, edge) / std::max(1e-12, dot(edge, edge)), 0.0, 1.0);
    out = std::min(out, distance(p, a + along * edge));
  }
  return out;
}

/// Looked at every metre.
bool leads_far_outside(const Ring& field, Point a, Point b, double far_m) {
  const int steps = static_cast<int>(distance(a, b)) + 1;
  for (int i = 0; i <= steps; ++i) {
    const Point p = a + (1.0 * i / steps) * (b - a);
    if (!contains(field, p) && off_edge_m(field, p) > far_m) return true;
  }
  return false;
}

struct Line {
  Point start, end;
};

std::vector<Line> lines_of(const std::vector<TrackPiece>& pieces) {
  std::vector<Line> out;
  for (const TrackPiece& piece : pieces) {
    if (!piece.after_crossing) out.push_back({piece.start, piece.end});
    out.back().end = piece.end;
  }
  return out;
}

}  // namespace

Hops hops_of(const Plan& plan) {
  Hops out;
  for (std::size_t i = 1; i < plan.pieces.size(); ++i) {
    if (plan.pieces[i].after_crossing) continue;
    const Point from = plan.pieces[i - 1].end, to = plan.pieces[i].start;
    ++out.count;
    out.length_m += distance(from, to);
    double through_m = 0;
    for (const Obstacle& obstacle : plan.field.obstacles)
      if (obstacle.kind == ObstacleKind::kObstacle) through_m += inside_m(obstacle.shape, from, to);
    out.through_obstacles += through_m > 0.1 ? 1 : 0;
    out.far_outside += leads_far_outside(plan.field.outer, from, to, plan.machine.width_m) ? 1 : 0;
  }
  return out;
}

double nearest_neighbour_m(const std::vector<TrackPiece>& pieces) {
  std::vector<Line> waiting = lines_of(pieces);
  if (waiting.empty()) return 0;
  Point at = waiting.front().end;
  waiting.erase(waiting.begin());
  double out = 0;
  while (!waiting.empty()) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    bool backwards = false;
    for (std::size_t i = 0; i < waiting.size(); ++i)
      for (const bool back : {false, true}) {
        const double reach = distance(at, back ? waiting[i].end : waiting[i].start);
        if (reach >= nearest) continue;
        nearest = reach;
        next = i;
        backwards = back;
      }
    out += nearest;
    at = backwards ? waiting[next].start : waiting[next].end;
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return out;
}

}  // namespace tramline::testing_support
