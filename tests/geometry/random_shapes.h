#pragma once
// Random shapes to hold the geometry against what is found by looking at every piece of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline::testing {

/// The random numbers of one case. While it lives, every failure names the case.
class RandomCase : public std::mt19937_64 {
 public:
  explicit RandomCase(int number)
      : std::mt19937_64(static_cast<unsigned long long>(number)),
        trace_("random case", 0, "case " + std::to_string(number)) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(*this); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(*this); }
  Point point_in(const Box& box) { return {between(box.min_x, box.max_x), between(box.min_y, box.max_y)}; }

 private:
  ::testing::ScopedTrace trace_;
};

/// A star-shaped ring with a corner in each of `corners` equal sectors about the centre; counter-clockwise.
inline Ring random_star(RandomCase& random, Point centre, double least_radius, double most_radius,
                        int corners) {
  Ring out;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + random.between(0.1, 0.9)) * 2 * std::numbers::pi / corners;
    out.push_back(centre +
                  random.between(least_radius, most_radius) * Point{std::cos(angle), std::sin(angle)});
  }
  return out;
}

/// A star of at most 50 m with a hole about its centre, and a smaller star 100 m east of it.
inline Region random_region(RandomCase& random) {
  Polygon holed{random_star(random, {0, 0}, 20, 50, random.whole(5, 12)), {}};
  holed.holes.push_back(reversed(random_star(random, {0, 0}, 3, 10, random.whole(3, 6))));
  return {holed, {random_star(random, {100, 5}, 10, 30, random.whole(4, 8)), {}}};
}

/// An arc that goes on from `from` in the given direction and turns by the angle, to the left where positive.
inline PathSegment arc_onwards(Point from, Point direction, double radius, double turn) {
  const double sense = turn > 0 ? 1 : -1;
  const Point centre = from + (sense * radius) * left_of(direction);
  return {from, centre + turned(from - centre, turn), sense / radius};
}

/// Lines and arcs that join without a kink; it may cross itself. Arcs of exactly half a circle are left out:
/// their ends and curvature give their headings to half the digits only.
inline Path random_smooth_path(RandomCase& random, int segments, double least_radius) {
  Path out;
  Point at{random.between(-20, 20), random.between(-20, 20)};
  Point direction = turned({1, 0}, random.between(-3, 3));
  for (int i = 0; i < segments; ++i) {
    if (random.whole(0, 1) == 0) {
      out.push_back({at, at + random.between(2, 40) * direction, 0});
    } else {
      const double turn = (random.whole(0, 1) == 0 ? -1 : 1) * random.between(0.2, 3.1);
      out.push_back(arc_onwards(at, direction, random.between(least_radius, 40), turn));
      direction = turned(direction, turn);
    }
    at = out.back().to;
  }
  return out;
}

/// In closed form: where the ray from the centre through p misses the arc, one of its ends is the nearest.
inline double distance_to(const PathSegment& segment, Point p) {
  if (segment.straight()) return distance_to_segment(p, segment.from, segment.to);
  const Point about = centre(segment);
  const Point start = segment.curvature > 0 ? segment.from : segment.to;
  const Point end = segment.curvature > 0 ? segment.to : segment.from;
  const auto anticlockwise_from_start = [&](Point q) {
    const double angle =
        std::atan2(q.y - about.y, q.x - about.x) - std::atan2(start.y - about.y, start.x - about.x);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  };
  if (anticlockwise_from_start(p) <= anticlockwise_from_start(end))
    return std::abs(distance(p, about) - radius(segment));
  return std::min(distance(p, segment.from), distance(p, segment.to));
}

inline double distance_to(const Path& path, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path) least = std::min(least, distance_to(segment, p));
  return least;
}

}  // namespace tramline::testing
