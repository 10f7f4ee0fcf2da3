#include "tramline/avoidance/detour_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tramline {
namespace {

/// Discs of one radius whose centres form the upper side of a convex polygon, left to right.
struct Hull {
  std::vector<Point> centres;
  double radius = 0;
};

/// How the path comes back from the hull to the track. Mirrored along the track the way there is the
/// same problem.
struct Approach {
  std::size_t vertex = 0;  ///< of the hull, where the path leaves it
  Point normal;            ///< unit, outward, where the path leaves the hull
  double arc_centre = 0;   ///< along, of the arc back to the track; a line may lead to it
};

/// Steepest line back to the track.
constexpr double kSteepest = 75 * std::numbers::pi / 180;
/// Shorter segments than this are left out, m.
constexpr double kDust = 1e-9;

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

/// Every disc lies within one of the common radius that touches it at its highest point.
Hull pressed(const std::vector<KeepOut>& discs, double common_radius) {
  std::vector<Point> centres;
  for (const KeepOut& disc : discs)
    centres.push_back({disc.centre.x, disc.centre.y - (common_radius - disc.radius)});
  return {upper_hull(std::move(centres)), common_radius};
}

double largest_radius(const std::vector<KeepOut>& discs) {
  double largest = 0;
  for (const KeepOut& disc : discs) largest = std::max(largest, disc.radius);
  return largest;
}

/// Where a disc of radius `arc` that rolls on the track from the right first touches the hull.
Approach first_touch(const Hull& hull, double arc) {
  const double reach = arc + hull.radius;
  Approach out;
  out.arc_centre = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.centres.size(); ++i) {
    const Point v = hull.centres[i];
    const double rise = arc - v.y;
    if (std::abs(rise) <= reach) {
      const double along = v.x + std::sqrt((reach - rise) * (reach + rise));
      if (along > out.arc_centre) out = {i, (1 / reach) * (Point{along, arc} - v), along};
    }
    if (i + 1 == hull.centres.size()) break;
    // On the edge to the next vertex, whose normal points up.
    const Point edge = hull.centres[i + 1] - v;
    const Point normal = (1 / length(edge)) * Point{-edge.y, edge.x};
    if (edge.y >= 0) continue;  // a rising edge faces the other way
    const double along = v.x + (reach - normal.y * rise) / normal.x;
    const double foot = dot(Point{along, arc} - v, edge);
    if (foot > 0 && foot < dot(edge, edge) && along > out.arc_centre) out = {i, normal, along};
  }
  return out;
}

/// Down a line at the steepest slope that touches the hull.
Approach down_a_line(const Hull& hull, double arc) {
  Approach out;
  out.normal = {std::sin(kSteepest), std::cos(kSteepest)};
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.centres.size(); ++i)
    if (const double height = dot(out.normal, hull.centres[i]); height > highest) {
      highest = height;
      out.vertex = i;
    }
  out.arc_centre = (highest + hull.radius + arc - out.normal.y * arc) / out.normal.x;
  return out;
}

/// nullopt where the hull does not reach over the track.
std::optional<Approach> approach_to(const Hull& hull, double arc) {
  Approach out = first_touch(hull, arc);
  const bool below =
      std::all_of(hull.centres.begin(), hull.centres.end(), [&](Point v) { return v.y + hull.radius <= 0; });
  if (below) return std::nullopt;
  const double drop = out.normal.y;  // cosine of the heading against the track
  if (!std::isfinite(out.arc_centre) || drop < 0 || hull.centres.back().y > arc)
    return down_a_line(hull, arc);
  return out;
}

Hull mirrored(Hull hull) {
  for (Point& v : hull.centres) v.x = -v.x;
  std::reverse(hull.centres.begin(), hull.centres.end());
  return hull;
}

Approach mirrored(Approach approach, const Hull& hull) {
  approach.vertex = hull.centres.size() - 1 - approach.vertex;
  approach.normal.x = -approach.normal.x;
  approach.arc_centre = -approach.arc_centre;
  return approach;
}

/// Appends segments, leaving out those without length.
class Pen {
 public:
  explicit Pen(Point at) : at_(at) {}
  void draw_to(Point to, double curvature) {
    if (distance(at_, to) <= kDust) return;
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

/// Round a vertex of the hull, from one normal to another. Near half a circle chord and curvature say little
/// about where an arc runs, so that one is drawn in two.
void draw_round(Pen& pen, Point centre, double radius, Point from, Point to) {
  constexpr double kWide = -0.6;  // cosine of 127 degrees
  if (dot(from, to) < kWide) {
    const Point along = to - from;
    pen.draw_to(centre + (radius / length(along)) * Point{-along.y, along.x}, -1 / radius);
  }
  pen.draw_to(centre + radius * to, -1 / radius);
}

Path drawn(const Hull& hull, const Approach& in, const Approach& out, double arc) {
  Pen pen({in.arc_centre, 0});
  pen.draw_to(Point{in.arc_centre, arc} - arc * in.normal, 1 / arc);
  for (std::size_t i = in.vertex; i <= out.vertex; ++i) {
    const Point arriving = i == in.vertex ? in.normal : normal_before(hull, i);
    const Point leaving = i == out.vertex ? out.normal : normal_before(hull, i + 1);
    pen.draw_to(hull.centres[i] + hull.radius * arriving, 0);
    draw_round(pen, hull.centres[i], hull.radius, arriving, leaving);
  }
  pen.draw_to(Point{out.arc_centre, arc} - arc * out.normal, 0);
  pen.draw_to({out.arc_centre, 0}, 1 / arc);
  return pen.take();
}

std::optional<Path> path_round(const Hull& hull, double arc) {
  const std::optional<Approach> out = approach_to(hull, arc);
  const Hull other_way = mirrored(hull);
  const std::optional<Approach> in = approach_to(other_way, arc);
  if (!out || !in) return std::nullopt;
  const Approach there = mirrored(*in, hull);
  if (there.vertex > out->vertex) return std::nullopt;
  return drawn(hull, there, *out, arc);
}

}  // namespace

std::optional<Path> detour_path(const std::vector<KeepOut>& discs, double radius_m) {
  return path_round(pressed(discs, std::max(radius_m, largest_radius(discs))), radius_m);
}

std::optional<Path> unrounded_detour_path(const std::vector<KeepOut>& discs, double radius_m) {
  return path_round(pressed(discs, largest_radius(discs)), radius_m);
}

}  // namespace tramline
