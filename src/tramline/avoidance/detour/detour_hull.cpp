#include "tramline/avoidance/detour/detour_hull.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

std::vector<Point> upper_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Point> out;
  for (const Point p : points) {
    while (out.size() >= 2 && cross(out.back() - out[out.size() - 2], p - out.back()) >= 0) out.pop_back();
    if (!out.empty() && out.back().x == p.x) out.pop_back();
    out.push_back(p);
  }
  return out;
}

/// Appends segments, leaving out those that are too short for a direction.
class Pen {
 public:
  explicit Pen(Point at) : at_(at) {}
  void draw_to(Point to, double curvature) {
    if (distance(at_, to) <= kShortest_m) return;
    path_.push_back({at_, to, curvature});
    at_ = to;
  }
  Path take() { return std::move(path_); }

 private:
  Point at_;
  Path path_;
};

/// Unit normal of the hull's edge that ends at a vertex.
Point normal_before(const Hull& hull, std::size_t vertex) {
  const Point edge = hull.centres[vertex] - hull.centres[vertex - 1];
  return (1 / length(edge)) * Point{-edge.y, edge.x};
}

/// Appends the arc round a vertex of the hull, from one normal to another. Near half a circle chord and
/// curvature determine an arc poorly, so it is drawn in two parts.
void append_arc(Pen& pen, Point centre, double radius, Point from, Point to) {
  constexpr double kWide = -0.6;  // cosine of 127 degrees
  if (dot(from, to) < kWide) {
    const Point along = to - from;
    pen.draw_to(centre + (radius / length(along)) * Point{-along.y, along.x}, -1 / radius);
  }
  pen.draw_to(centre + radius * to, -1 / radius);
}

}  // namespace

Hull hull_round(const std::vector<KeepOut>& discs, double radius_m, HullCorners corners) {
  assert(!discs.empty());
  double common = corners == HullCorners::kDrivable ? radius_m : 0;
  for (const KeepOut& disc : discs) common = std::max(common, disc.radius);
  std::vector<Point> centres;
  for (const KeepOut& disc : discs)
    centres.push_back({disc.centre.x, disc.centre.y - (common - disc.radius)});
  return {upper_hull(std::move(centres)), common};
}

Hull mirrored(Hull hull) {
  for (Point& v : hull.centres) v.x = -v.x;
  std::reverse(hull.centres.begin(), hull.centres.end());
  return hull;
}

Approach mirrored(Approach approach, const Hull& hull) {
  approach.vertex = hull.centres.size() - 1 - approach.vertex;
  approach.normal.x = -approach.normal.x;
  approach.arc_centre.x = -approach.arc_centre.x;
  approach.on_track.x = -approach.on_track.x;
  return approach;
}

SteepLine steepest_line(const Hull& hull) {
  SteepLine out;
  out.touching.normal = {std::sin(kSteepest), std::cos(kSteepest)};
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.centres.size(); ++i)
    if (const double height = dot(out.touching.normal, hull.centres[i]); height > highest) {
      highest = height;
      out.touching.vertex = i;
    }
  out.off_m = highest + hull.radius;
  return out;
}

Path hull_path(const Hull& hull, const Approach& in, const Approach& out, double arc) {
  assert(in.vertex <= out.vertex);
  Pen pen(in.on_track);
  pen.draw_to(in.arc_centre - arc * in.normal, 1 / arc);
  for (std::size_t i = in.vertex; i <= out.vertex; ++i) {
    const Point arriving = i == in.vertex ? in.normal : normal_before(hull, i);
    const Point leaving = i == out.vertex ? out.normal : normal_before(hull, i + 1);
    pen.draw_to(hull.centres[i] + hull.radius * arriving, 0);
    append_arc(pen, hull.centres[i], hull.radius, arriving, leaving);
  }
  pen.draw_to(out.arc_centre - arc * out.normal, 0);
  pen.draw_to(out.on_track, 1 / arc);
  return pen.take();
}

}  // namespace tramline
