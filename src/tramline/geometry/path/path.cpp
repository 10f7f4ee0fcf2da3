#include "tramline/geometry/path/path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Chords needed for an arc of this radius to stay within the sagitta r·(1 − cos(step/2)).
int chord_count(double turning_rad, double radius_m, double sagitta_m) {
  const double step = 2 * std::acos(std::max(0.0, 1 - std::min(1.0, sagitta_m / radius_m)));
  return std::max(1, static_cast<int>(std::ceil(std::abs(turning_rad) / step)));
}

/// Points `offset_m` to the left of the segment, both ends included.
void append_offset(const PathSegment& segment, double offset_m, int count, std::vector<Point>& out) {
  const Point at_start = left_of(direction_at_start(segment)), at_end = left_of(direction_at_end(segment));
  out.push_back(segment.from + offset_m * at_start);
  if (!segment.straight()) {
    const Point middle = centre(segment);
    const double reach = 1 / segment.curvature;  // the centre lies this far to the left
    for (int i = 1; i < count; ++i)
      out.push_back(middle + (offset_m - reach) * turned(at_start, turning(segment) * i / count));
  }
  out.push_back(segment.to + offset_m * at_end);
}

/// Ends that meet. The inner side of an arc as tight as the band is wide is a place, too; where rounding
/// makes it a loop, it would cross its neighbours.
std::vector<Point> without_repeated(std::vector<Point> points, double same_m) {
  const Point last = points.back();
  const auto end = std::unique(points.begin(), points.end(),
                               [same_m](Point a, Point b) { return distance(a, b) < same_m; });
  points.erase(end, points.end());
  points.back() = last;
  return points;
}

std::vector<Point> offset_chords(const Path& path, double offset_m, double half_width_m, double sagitta_m) {
  std::vector<Point> out;
  for (const PathSegment& segment : path) {
    const int count =
        segment.straight() ? 1 : chord_count(turning(segment), radius(segment) + half_width_m, sagitta_m);
    append_offset(segment, offset_m, count, out);
  }
  return without_repeated(std::move(out), offset_m == 0 ? kShortest_m : kSamePlace_m);
}

bool cross_each_other(Point a, Point b, Point c, Point d) {
  const double side_c = cross(b - a, c - a), side_d = cross(b - a, d - a);
  const double side_a = cross(d - c, a - c), side_b = cross(d - c, b - c);
  return (side_c > 0) != (side_d > 0) && (side_a > 0) != (side_b > 0);
}

/// Box of a segment: that of the chord, for an arc grown by its height above the chord.
Box box_of(const PathSegment& segment) {
  const Box box = bounds(segment.from, segment.to);
  if (segment.straight()) return box;
  const Point chord = segment.to - segment.from;
  const double half_square = 0.25 * dot(chord, chord), reach = radius(segment);
  return box.grown(half_square / (reach + std::sqrt(std::max(0.0, reach * reach - half_square))));
}

/// An arc with what the distance to it asks for.
class Arc {
 public:
  explicit Arc(const PathSegment& arc)
      : arc_(arc),
        centre_(tramline::centre(arc)),
        radius_(radius(arc)),
        middle_(turned(arc.from - centre_, 0.5 * turning(arc))),
        cos_half_(std::cos(0.5 * turning(arc))) {}

  /// Whether the ray from the centre through p meets the arc.
  bool faces(Point p) const {
    const Point d = p - centre_;
    return dot(d, middle_) >= cos_half_ * tramline::length(d) * radius_;
  }

  double distance_to(Point p) const {
    if (faces(p)) return std::abs(distance(p, centre_) - radius_);
    return std::min(distance(p, arc_.from), distance(p, arc_.to));
  }

  bool meets(Point a, Point b) const {
    const Point along = b - a, from_centre = a - centre_;
    const double square = dot(along, along);
    if (square == 0) return false;
    const double half = dot(along, from_centre) / square;
    const double root = half * half - (dot(from_centre, from_centre) - radius_ * radius_) / square;
    if (root < 0) return false;
    for (const double t : {-half - std::sqrt(root), -half + std::sqrt(root)})
      if (t >= 0 && t <= 1 && faces(a + t * along)) return true;
    return false;
  }

  /// Distance at the edge's point nearest to the centre, where that is inside the edge.
  double distance_at_foot(Point a, Point b) const {
    const Point along = b - a;
    const double square = dot(along, along);
    if (square == 0) return std::numeric_limits<double>::infinity();
    const double t = dot(centre_ - a, along) / square;
    if (t <= 0 || t >= 1) return std::numeric_limits<double>::infinity();
    return distance_to(a + t * along);
  }

 private:
  const PathSegment& arc_;
  Point centre_;
  double radius_;
  Point middle_;  ///< from the centre to the arc's middle
  double cos_half_;
};

}  // namespace

double radius(const PathSegment& segment) {
  return segment.straight() ? std::numeric_limits<double>::infinity() : 1 / std::abs(segment.curvature);
}

Point centre(const PathSegment& arc) {
  assert(!arc.straight());
  const Point chord = arc.to - arc.from;
  const double half = 0.5 * length(chord), reach = radius(arc);
  const double height = std::sqrt(std::max(0.0, (reach - half) * (reach + half)));
  const double sense = arc.curvature > 0 ? 1 : -1;
  return midpoint(arc.from, arc.to) + (sense * height / (2 * half)) * left_of(chord);
}

double turning(const PathSegment& segment) {
  const double half_sine = 0.5 * distance(segment.from, segment.to) * segment.curvature;
  return 2 * std::asin(std::clamp(half_sine, -1.0, 1.0));
}

double length(const PathSegment& segment) {
  if (segment.straight()) return distance(segment.from, segment.to);
  return turning(segment) / segment.curvature;
}

Point direction_at_start(const PathSegment& segment) {
  assert(segment.from != segment.to);
  const Point chord = segment.to - segment.from;
  return turned((1 / length(chord)) * chord, -0.5 * turning(segment));
}

Point direction_at_end(const PathSegment& segment) {
  assert(segment.from != segment.to);
  const Point chord = segment.to - segment.from;
  return turned((1 / length(chord)) * chord, 0.5 * turning(segment));
}

Path straight_path(Point from, Point to) { return {{from, to, 0}}; }

double length(const Path& path) {
  double sum = 0;
  for (const PathSegment& segment : path) sum += length(segment);
  return sum;
}

double smallest_radius(const Path& path) {
  double least = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path) least = std::min(least, radius(segment));
  return least;
}

bool has_arcs(const Path& path) { return std::isfinite(smallest_radius(path)); }

Path reversed(const Path& path) {
  Path out;
  out.reserve(path.size());
  for (auto segment = path.rbegin(); segment != path.rend(); ++segment)
    out.push_back({segment->to, segment->from, -segment->curvature});
  return out;
}

std::vector<Point> chords(const Path& path, double sagitta_m) { return offset_chords(path, 0, 0, sagitta_m); }

Ring band(const Path& path, double width_m, double sagitta_m) {
  const double half = 0.5 * width_m;
  Ring out = offset_chords(path, -half, half, sagitta_m);
  const std::vector<Point> left = offset_chords(path, half, half, sagitta_m);
  out.insert(out.end(), left.rbegin(), left.rend());
  return out;
}

Polygon closed_band(const Path& path, double width_m, double sagitta_m) {
  const double half = 0.5 * width_m;
  Ring outer = offset_chords(path, -half, half, sagitta_m),
       inner = offset_chords(path, half, half, sagitta_m);
  for (Ring* ring : {&outer, &inner}) ring->pop_back();
  if (std::abs(signed_area(inner)) > std::abs(signed_area(outer))) std::swap(outer, inner);
  Polygon out{std::move(outer), {}};
  if (std::abs(signed_area(inner)) > kNoHole_m2) out.holes.push_back(std::move(inner));
  return oriented(std::move(out));
}

Box reach_of(const Path& path, double width_m) {
  Box box;
  for (const PathSegment& segment : path) box.extend(box_of(segment));
  return box.grown(0.5 * width_m);
}

std::vector<Box> reaches_of(const Path& path, double width_m) {
  std::vector<Box> out;
  out.reserve(path.size());
  for (const PathSegment& segment : path) out.push_back(box_of(segment).grown(0.5 * width_m));
  return out;
}

std::vector<Path> runs_near(const Path& path, const std::vector<Box>& reaches,
                            const std::vector<Box>& windows) {
  std::vector<Path> out;
  bool goes_on = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool is_near = std::any_of(windows.begin(), windows.end(),
                                     [&](const Box& window) { return intersects(reaches[i], window); });
    if (is_near && !goes_on) out.emplace_back();
    if (is_near) out.back().push_back(path[i]);
    goes_on = is_near;
  }
  return out;
}

double distance_to_edge(const PathSegment& segment, Point a, Point b) {
  if (segment.straight()) {
    if (cross_each_other(segment.from, segment.to, a, b)) return 0;
    return std::min({distance_to_segment(segment.from, a, b), distance_to_segment(segment.to, a, b),
                     distance_to_segment(a, segment.from, segment.to),
                     distance_to_segment(b, segment.from, segment.to)});
  }
  const Arc arc(segment);
  if (arc.meets(a, b)) return 0;
  return std::min({arc.distance_to(a), arc.distance_to(b), distance_to_segment(segment.from, a, b),
                   distance_to_segment(segment.to, a, b), arc.distance_at_foot(a, b)});
}

}  // namespace tramline
