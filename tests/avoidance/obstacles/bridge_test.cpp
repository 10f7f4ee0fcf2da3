// Land between a ring and a region: by hand, and by what its definition asks of every point of it.

#include "tramline/avoidance/obstacles/bridge.h"

#include <gtest/gtest.h>

#include <random>

#include "avoidance/pole_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::bridge_test {

using testing_support::box;

double distance_to_line(Point p, const Ring& ring) {
  double least = 1e9;
  for (std::size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

Point nearest_on_line(Point p, const Ring& ring) {
  Point best = ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], along = ring[(i + 1) % ring.size()] - a;
    const Point foot = a + std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) * along;
    if (distance(p, foot) < distance(p, best)) best = foot;
  }
  return best;
}

// Two metres between a wall and a shed 3 m long: 2 × 3 m are given up.
TEST(Bridge, BetweenTwoRectanglesIsARectangle) {
  const Ring wall = box(0, 0, 10, 10);
  const Region shed{{box(12, 3.5, 20, 6.5), {}}};
  const Region between = difference(bridge(wall, shed, 3), shed);
  EXPECT_NEAR(area(between), 2 * 3, 1e-4);
  EXPECT_NEAR(area(intersection(between, {{box(10, 3.5, 12, 6.5), {}}})), 2 * 3, 1e-4);
}

TEST(Bridge, IsNoneWhereTheyAreFarEnoughApart) {
  const Ring wall = box(0, 0, 10, 10);
  EXPECT_TRUE(bridge(wall, {{box(13.1, 2, 20, 5), {}}}, 3).empty());
  EXPECT_TRUE(bridge(wall, {{box(12.5, 12.5, 20, 20), {}}}, 3).empty()) << "3.5 m from corner to corner";
  EXPECT_FALSE(bridge(wall, {{box(12, 12, 20, 20), {}}}, 3).empty()) << "2.8 m";
  EXPECT_TRUE(bridge(wall, {}, 3).empty());
}

// A shed inside, near the field's edge: a ring is a line, whichever side the region lies on. Only the part
// nearer than the gap counts: 1.01 times it, for round buffers, of a side that runs away at 45°.
TEST(Bridge, ReachesAsFarAsTheGap) {
  const Ring edge = box(0, 0, 50, 50);
  const Region shed{{{{1, 20}, {21, 20}, {21, 40}}, {}}};
  const Region between = difference(bridge(edge, shed, 4), shed);
  // The side from (1, 20) to (21, 40) is within 4.04 m of the edge x = 0 up to y = 23.04.
  EXPECT_NEAR(bounds(between).min_x, 0, 1e-4);
  EXPECT_NEAR(bounds(between).min_y, 20, 1e-4);
  EXPECT_NEAR(bounds(between).max_y, 23.04, 1e-3);
  // Between the edge and the side: from 1 m to 4.04 m wide, 3.04 m long.
  EXPECT_NEAR(area(between), 3.04 * 0.5 * (1 + 4.04), 1e-2);
}

// Parts of a region that touch along an edge are joined to the ring one by one.
TEST(Bridge, HasOneForEachPartOfTheRegion) {
  const Ring wall = box(0, 0, 10, 10);
  const Region sheds{{box(12, 0, 14, 4), {}}, {box(12, 4, 14, 10), {}}, {box(-5, 5, -1, 6), {}}};
  EXPECT_NEAR(area(difference(bridge(wall, sheds, 3), sheds)), 2 * 10 + 1 * 1, 1e-3);
}

// What is nearer than the gap is joined to the ring by the shortest way. Nothing is given up that is farther
// than that from either of a ring and a convex region.
TEST(Bridge, JoinsAllThatIsNearAndNothingElse) {
  int joined = 0;
  testing::for_each_seed(60, [&joined](std::mt19937_64& random, int number) {
    std::uniform_real_distribution<double> at(-14, 14), gap(1, 12);
    const Ring ring = testing::random_star(random, {0, 0}, 6, 20, 3 + number % 9);
    std::vector<Point> points;
    const Point centre{25 + at(random), at(random)};
    for (int i = 0; i < 7; ++i) points.push_back(centre + 0.4 * Point{at(random), at(random)});
    const Region region = convex_hull(points);
    const double gap_m = gap(random);
    const Region between = bridge(ring, region, gap_m);
    for (const Polygon& part : between)
      for (const Point p : part.outer) {
        ASSERT_LE(distance_to_line(p, ring), 1.01 * gap_m + 1e-5);
        const Ring small{p, p + Point{1e-6, 0}, p + Point{0, 1e-6}};
        ASSERT_LE(distance_between(region, {{small, {}}}), 1.01 * gap_m + 1e-5);
      }
    const Region filled = buffered(unite(unite(between), region), 1e-4, JoinStyle::kMitre);
    const Ring& outline = region.front().outer;
    for (std::size_t i = 0; i < outline.size(); ++i)
      for (const double share : {0.0, 0.3, 0.7}) {
        const Point p = outline[i] + share * (outline[(i + 1) % outline.size()] - outline[i]);
        const Point foot = nearest_on_line(p, ring);
        if (distance(p, foot) >= gap_m || distance(p, foot) < 1e-3) continue;
        ++joined;
        for (const double way : {0.1, 0.5, 0.9})
          ASSERT_TRUE(contains(filled, p + way * (foot - p))) << "from " << p.x << ' ' << p.y;
      }
  });
  if (testing::case_count(60) >= 60) {
    EXPECT_GT(joined, 10);
  }
}

}  // namespace tramline::bridge_test
