#include "support/off_the_land.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tramline::testing {
namespace {

/// Points are so far apart on the path and on the bar, m.
constexpr double kApart_m = 0.05;

using Edge = std::array<Point, 2>;

/// A ring, with those of its edges that are near a turn, and that a ray from there to the right may cross.
class RingNearby {
 public:
  RingNearby(const Ring& ring, const Box& reach) {
    const Box right{reach.min_x, reach.min_y, std::numeric_limits<double>::infinity(), reach.max_y};
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
      const Box box = bounds(edge[0], edge[1]);
      if (intersects(box, reach)) near_.push_back(edge);
      if (intersects(box, right)) right_.push_back(edge);
    }
  }

  /// Of a point within reach.
  bool inside(Point p) const {
    bool in = false;
    for (const auto& [a, b] : right_)
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    return in;
  }

  bool any_near() const { return !near_.empty(); }

  double distance_m(Point p) const {
    double out = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : near_) out = std::min(out, distance_to_segment(p, a, b));
    return out;
  }

 private:
  std::vector<Edge> near_, right_;
};

/// The places of the axle on a path and its direction there, in steps of the midpoint rule far shorter than
/// any radius.
template <class See>
void each_place(const SteeredPath& path, const See& see) {
  constexpr int kStepsBetween = 10;
  for (const SteeredStretch& stretch : path) {
    const double sense = stretch.gear == Gear::kForward ? 1 : -1;
    const int steps = kStepsBetween * std::max(1, static_cast<int>(std::ceil(stretch.length_m / kApart_m)));
    const double step_m = stretch.length_m / steps;
    Point at = stretch.start.at;
    double heading = std::atan2(stretch.start.heading.unit().y, stretch.start.heading.unit().x);
    for (int i = 0; i <= steps; ++i) {
      if (i % kStepsBetween == 0) see(at, Point{std::cos(heading), std::sin(heading)});
      const double share = (i + 0.5) / steps;
      const double curvature =
          stretch.curvature_at_start + share * (stretch.curvature_at_end - stretch.curvature_at_start);
      const double turned = sense * step_m * curvature;
      at = at + sense * step_m * Point{std::cos(heading + 0.5 * turned), std::sin(heading + 0.5 * turned)};
      heading += turned;
    }
  }
}

}  // namespace

double off_the_land_m(const Field& field, double width_m, const SteeredPath& path) {
  const double half_m = 0.5 * width_m;
  Box reach;
  each_place(path, [&](Point at, Point) { reach.extend(at); });
  reach = reach.grown(half_m + 1);
  double off_m = 0;
  const auto look = [&](const Ring& ring, bool land_inside) {
    const RingNearby nearby(ring, reach);
    // Far from all edges every point is on the side of the first one.
    if (!nearby.any_near()) {
      if (nearby.inside(path.front().start.at) != land_inside) off_m = half_m;
      return;
    }
    each_place(path, [&](Point at, Point ahead) {
      const int points = 1 + static_cast<int>(std::ceil(width_m / kApart_m));
      for (int i = 0; i < points; ++i) {
        const Point p = at + (2.0 * i / (points - 1) - 1) * half_m * Point{-ahead.y, ahead.x};
        if (nearby.inside(p) != land_inside) off_m = std::max(off_m, nearby.distance_m(p));
      }
    });
  };
  look(field.outer, true);
  for (const Obstacle& obstacle : field.obstacles) look(obstacle.shape.outer, false);
  return off_m;
}

}  // namespace tramline::testing
