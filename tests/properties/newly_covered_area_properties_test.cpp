// Closed-form areas between lines and arcs: against polygon booleans with fine chords, and against
// themselves.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline::newly_covered_area_properties_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box kEverywhere{-kInfinity, -kInfinity, kInfinity, kInfinity};
constexpr double kSagitta = 1e-6;

double uniform(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

int any_of(std::mt19937_64& random, int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(random);
}

/// A unit vector, anticlockwise from north.
Point ahead(double heading) { return {-std::sin(heading), std::cos(heading)}; }

/// Lines and arcs in turn with continuous tangents, headings within 85 degrees of north. Some arcs are
/// as tight as the band is wide, some all but straight, some are split into two of one circle.
Path random_path(std::mt19937_64& random, double width) {
  const double most = 85 * std::numbers::pi / 180;
  Path path;
  Point at{uniform(random, -10, 10), uniform(random, -20, 0)};
  double heading = any_of(random, 0, 1) == 0 ? 0 : uniform(random, -most, most);
  const int count = any_of(random, 1, 6);
  for (int i = 0; i < count; ++i) {
    if (any_of(random, 0, 2) == 0) {
      const Point to = at + uniform(random, 0, 8) * ahead(heading);
      path.push_back({at, to, 0});
      at = to;
      continue;
    }
    const int kind = any_of(random, 0, 5);
    const double to_heading = kind == 1 ? heading + 1e-4 : uniform(random, -most, most);
    const double radius = kind == 0 ? 0.5 * width : kind == 1 ? 1e5 : uniform(random, 0.5 * width, 12);
    const double curvature = (to_heading > heading ? 1 : -1) / radius;
    const Point to = at + (1 / curvature) * Point{std::cos(to_heading) - std::cos(heading),
                                                  std::sin(to_heading) - std::sin(heading)};
    path.push_back({at, to, curvature});
    at = to;
    heading = to_heading;
  }
  return path;
}

Ring rectangle(const Box& b) {
  return {{b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}};
}

Ring rotated(Ring ring, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point& p : ring) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return ring;
}

Box random_box(std::mt19937_64& random) {
  const double x = uniform(random, -25, 20), y = uniform(random, -25, 25);
  return {x, y, x + uniform(random, 0.5, 8), y + uniform(random, 1, 30)};
}

/// The row that a path begins in, and a box that touches one of its bends or runs along its edge.
void append_touching_boxes(std::mt19937_64& random, const Path& path, double width, std::vector<Box>& out) {
  const double half = 0.5 * width;
  const Point begin = path.front().from;
  out.push_back({begin.x - half, begin.y - 20, begin.x + half, begin.y + uniform(random, -1, 6)});
  for (const PathSegment& segment : path) {
    if (segment.straight()) continue;
    const double reach = radius(segment) + (any_of(random, 0, 1) == 0 ? half : -half);
    const double x = centre(segment).x + std::copysign(reach, segment.curvature);
    const double low = segment.from.y - uniform(random, 0, 5), high = segment.to.y + uniform(random, 0, 5);
    out.push_back(any_of(random, 0, 1) == 0 ? Box{x - 2, low, x, high} : Box{x, low, x + 2, high});
    return;
  }
}

struct Scene {
  Field body;               ///< obstacles are its holes
  std::vector<Box> boxes;   ///< taken; some share edges
  std::vector<Ring> rings;  ///< taken, rotated
  std::vector<Path> taken;  ///< by bands
  std::vector<Path> paths;  ///< new bands
  double width = 0;
};

Scene random_scene(std::mt19937_64& random) {
  Scene out;
  out.body = testing::random_field(random, 4);
  const double shrink = uniform(random, 0.15, 1);
  for (Point& p : out.body.outer) p = shrink * p;
  for (Obstacle& obstacle : out.body.obstacles)
    for (Point& p : obstacle.shape.outer) p = shrink * p;
  out.width = uniform(random, 1, 5);
  for (int i = any_of(random, 0, 4); i > 0; --i) {
    const Box box = random_box(random);
    out.boxes.push_back(box);
    if (any_of(random, 0, 1) == 0)
      out.boxes.push_back({box.max_x, box.min_y - 1, box.max_x + out.width, uniform(random, box.min_y, 30)});
  }
  for (int i = any_of(random, 0, 2); i > 0; --i)
    out.rings.push_back(rotated(rectangle(random_box(random)), uniform(random, 0, 3)));
  for (int i = any_of(random, 0, 1); i > 0; --i) out.taken.push_back(random_path(random, out.width));
  for (int i = any_of(random, 1, 3); i > 0; --i) out.paths.push_back(random_path(random, out.width));
  if (any_of(random, 0, 1) == 0) append_touching_boxes(random, out.paths.front(), out.width, out.boxes);
  // The same ground taken and new, and new twice: curves that coincide.
  if (any_of(random, 0, 3) == 0) out.taken.push_back(out.paths.front());
  if (any_of(random, 0, 3) == 0) out.paths.push_back(out.paths.front());
  return out;
}

/// A box round the bands' chords, so hardly larger than the bands.
Box window_of(const std::vector<Path>& paths, double width) {
  Box out;
  for (const Path& path : paths) out.extend(bounds(band(path, width, 1e-3)));
  return out.grown(0.01);
}

double newly_covered_area(const Scene& scene, const Box& window) {
  RisingCurves curves;
  append_ring(scene.body.outer, Layer::kBody, window, curves);
  for (const Obstacle& hole : scene.body.obstacles)
    append_ring(reversed(hole.shape.outer), Layer::kBody, window, curves);
  for (const Box& box : scene.boxes) append_box(box, Layer::kCovered, window, curves);
  for (const Ring& ring : scene.rings) append_ring(ring, Layer::kCovered, window, curves);
  for (const Path& path : scene.taken) append_band(path, scene.width, Layer::kCovered, curves);
  for (const Path& path : scene.paths) append_band(path, scene.width, Layer::kNew, curves);
  return newly_covered_area(curves);
}

Region bands(const std::vector<Path>& paths, double width) {
  Region out;
  for (const Path& path : paths) out.push_back({band(path, width, kSagitta), {}});
  return unite(out);
}

double area_by_booleans(const Scene& scene) {
  Region holes, taken = bands(scene.taken, scene.width);
  for (const Obstacle& obstacle : scene.body.obstacles) holes.push_back(obstacle.shape);
  for (const Box& box : scene.boxes) taken.push_back({rectangle(box), {}});
  for (const Ring& ring : scene.rings) taken.push_back({ring, {}});
  const Region body = difference({{scene.body.outer, {}}}, unite(holes));
  return area(difference(intersection(bands(scene.paths, scene.width), body), unite(taken)));
}

double length_of_edges(const Scene& scene) {
  double out = 0;
  for (const std::vector<Path>& paths : {scene.paths, scene.taken})
    for (const Path& path : paths) out += 2 * (length(path) + scene.width);
  return out;
}

Scene moved(Scene scene, Point by) {
  const auto move = [by](Point p) { return p + by; };
  scene.body = testing::shifted(scene.body, by);
  for (Box& b : scene.boxes) b = {b.min_x + by.x, b.min_y + by.y, b.max_x + by.x, b.max_y + by.y};
  for (Ring& ring : scene.rings)
    for (Point& p : ring) p = move(p);
  for (Path& path : scene.taken) path = tramline::moved(path, move);
  for (Path& path : scene.paths) path = tramline::moved(path, move);
  return scene;
}

/// Runs `check` on random scenes.
template <class Check>
void for_random_scenes(int standard, Check check) {
  testing::for_each_seed(standard,
                         [&](std::mt19937_64& random, int) { check(random_scene(random), random); });
}

// Chords lie up to the sagitta off the edges of the bands, and the precision grid moves all edges of the
// result, of which those of body and boxes near the bands are no longer than a few times the bands'.
TEST(LayeredAreaProperties, AgreesWithPolygonBooleans) {
  int not_empty = 0;
  for_random_scenes(150, [&](const Scene& scene, std::mt19937_64&) {
    const double expected = area_by_booleans(scene);
    not_empty += expected > 0 ? 1 : 0;
    EXPECT_NEAR(newly_covered_area(scene, kEverywhere), expected,
                (kSagitta + 3 * kGridSize) * length_of_edges(scene));
  });
  EXPECT_GT(3 * not_empty, testing::case_count(150));
}

TEST(LayeredAreaProperties, IsTheSameInAWindowRoundTheNewGround) {
  for_random_scenes(2000, [](const Scene& scene, std::mt19937_64&) {
    EXPECT_NEAR(newly_covered_area(scene, window_of(scene.paths, scene.width)),
                newly_covered_area(scene, kEverywhere), 1e-9);
  });
}

// Far from the origin coordinates are rounded to 1.5e-11 m. At an arc of 85 + 85 degrees, nearly half a
// circle, the centre moves by that over the cosine of 85 degrees.
TEST(LayeredAreaProperties, IsTheSameFarFromTheOrigin) {
  for_random_scenes(2000, [](const Scene& scene, std::mt19937_64&) {
    EXPECT_NEAR(newly_covered_area(moved(scene, {1e5, 1e5}), kEverywhere),
                newly_covered_area(scene, kEverywhere), 1e-6);
  });
}

// What the first half of the bands covers and what the second half adds to it is what all of them cover.
// Every edge of the first half is there twice. Tolerance: rounding.
TEST(LayeredAreaProperties, AddsUpOverBandsTakenOneAfterTheOther) {
  for_random_scenes(2000, [](const Scene& scene, std::mt19937_64& random) {
    Scene first = scene;
    first.paths.push_back(random_path(random, scene.width));
    const Scene both = first;
    Scene second = first;
    second.paths = {first.paths.back()};
    first.paths.pop_back();
    second.taken.insert(second.taken.end(), first.paths.begin(), first.paths.end());
    EXPECT_NEAR(newly_covered_area(first, kEverywhere) + newly_covered_area(second, kEverywhere),
                newly_covered_area(both, kEverywhere), 1e-9);
  });
}

TEST(LayeredAreaProperties, OfABandAloneIsItsWidthTimesItsLength) {
  for_random_scenes(2000, [](const Scene& scene, std::mt19937_64&) {
    RisingCurves curves;
    append_box({-200, -200, 200, 200}, Layer::kBody, kEverywhere, curves);
    append_band(scene.paths.front(), scene.width, Layer::kNew, curves);
    EXPECT_NEAR(newly_covered_area(curves), scene.width * length(scene.paths.front()), 1e-9);
  });
}

}  // namespace tramline::newly_covered_area_properties_test
