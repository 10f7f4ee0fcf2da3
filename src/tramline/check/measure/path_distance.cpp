#include "tramline/check/measure/path_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline::check {
namespace {

/// A circle with the part of it that an arc is.
class Round {
 public:
  explicit Round(const PathSegment& arc) : centre_(tramline::centre(arc)), radius_(tramline::radius(arc)) {
    const double half = 0.5 * turning(arc), c = std::cos(half), s = std::sin(half);
    const Point first = arc.from - centre_;
    middle_ = {first.x * c - first.y * s, first.x * s + first.y * c};
    cos_half_ = c;
  }

  Point centre() const { return centre_; }
  double radius() const { return radius_; }
  Point point_at(Point direction) const { return centre_ + radius_ * direction; }
  bool has(Point on_circle) const {
    const Point d = on_circle - centre_;
    return dot(d, middle_) >= cos_half_ * length(d) * radius_;
  }

 private:
  Point centre_;
  double radius_;
  Point middle_;  ///< from the centre to the arc's middle
  double cos_half_;
};

bool meet(const Round& a, const Round& b, Point across, double apart_m) {
  const double along =
      (apart_m * apart_m + a.radius() * a.radius() - b.radius() * b.radius()) / (2 * apart_m);
  const double square = a.radius() * a.radius() - along * along;
  if (square < 0) return false;
  for (const double side : {-std::sqrt(square), std::sqrt(square)}) {
    const Point p = a.centre() + along * across + side * Point{-across.y, across.x};
    if (a.has(p) && b.has(p)) return true;
  }
  return false;
}

/// Between places inside both arcs; infinite where the ends are nearest. About one centre they always are.
double between_insides(const PathSegment& first, const PathSegment& second) {
  const Round a(first), b(second);
  double out = std::numeric_limits<double>::infinity();
  const double apart_m = distance(a.centre(), b.centre());
  if (apart_m == 0) return out;
  const Point across = (1 / apart_m) * (b.centre() - a.centre());
  if (meet(a, b, across, apart_m)) return 0;
  for (const double on_a : {-1.0, 1.0})
    for (const double on_b : {-1.0, 1.0}) {
      const Point p = a.point_at(on_a * across), q = b.point_at(on_b * across);
      if (a.has(p) && b.has(q)) out = std::min(out, distance(p, q));
    }
  return out;
}

}  // namespace

double distance_between(const PathSegment& a, const PathSegment& b) {
  if (a.straight()) return distance_to_edge(b, a.from, a.to);
  if (b.straight()) return distance_to_edge(a, b.from, b.to);
  return std::min({distance_to_edge(a, b.from, b.from), distance_to_edge(a, b.to, b.to),
                   distance_to_edge(b, a.from, a.from), distance_to_edge(b, a.to, a.to),
                   between_insides(a, b)});
}

double distance_between(const Path& a, const Path& b) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& first : a)
    for (const PathSegment& second : b) out = std::min(out, distance_between(first, second));
  return out;
}

}  // namespace tramline::check
