#include "tramline/geometry/path/newly_covered_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tramline::newly_covered_area_test {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box kEverywhere{-kInfinity, -kInfinity, kInfinity, kInfinity};
constexpr Box kLargeBody{-100, -100, 100, 100};

// A line, two quarter turns of radius 2 and a line: 6 m to the left and 4 + 4 + 5 m up.
const Path kS{{{0, -3}, {0, 0}, 0}, {{0, 0}, {-2, 2}, 0.5}, {{-2, 2}, {-4, 4}, -0.5}, {{-4, 4}, {-4, 9}, 0}};

RisingCurves curves_in(const Box& body = kLargeBody) {
  RisingCurves out;
  append_box(body, Layer::kBody, kEverywhere, out);
  return out;
}

/// A disc, from its quarters.
void append_disc(Point centre, double radius, Layer layer, RisingCurves& out) {
  const Point bottom{centre.x, centre.y - radius}, top{centre.x, centre.y + radius};
  for (const int side : {-1, 1}) {
    const Point middle{centre.x + side * radius, centre.y};
    out.push_back({bottom, middle, side / radius, layer, -side});
    out.push_back({middle, top, side / radius, layer, -side});
  }
}

/// A disc, from its halves.
void append_halves(Point centre, double radius, Layer layer, RisingCurves& out) {
  const Point bottom{centre.x, centre.y - radius}, top{centre.x, centre.y + radius};
  out.push_back({bottom, top, -1 / radius, layer, 1});
  out.push_back({bottom, top, 1 / radius, layer, -1});
}

Ring corners(const Box& b) {
  return {{b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}};
}

/// What two discs share, after any textbook.
double lens(double r, double s, double d) {
  const double a = (d * d + r * r - s * s) / (2 * d * r), b = (d * d + s * s - r * r) / (2 * d * s);
  const double kite = std::sqrt((-d + r + s) * (d + r - s) * (d - r + s) * (d + r + s));
  return r * r * std::acos(a) + s * s * std::acos(b) - 0.5 * kite;
}

TEST(LayeredArea, OfNothingIsNothing) {
  EXPECT_EQ(newly_covered_area({}), 0);
  EXPECT_EQ(newly_covered_area(curves_in()), 0);
  RisingCurves curves;
  append_box({0, 0, 1, 1}, Layer::kNew, kEverywhere, curves);
  EXPECT_EQ(newly_covered_area(curves), 0) << "no body";
}

TEST(LayeredArea, OfADiscHalfInTheBody) {
  for (const double centre : {0.0, 3.0, -7.0}) {
    RisingCurves curves = curves_in({centre, -100, 100, 100});
    append_disc({centre, 1}, 3, Layer::kNew, curves);
    EXPECT_NEAR(newly_covered_area(curves), kPi * 9 / 2, 1e-12);
    curves = curves_in({centre, -100, 100, 100});
    append_halves({centre, 1}, 3, Layer::kNew, curves);
    EXPECT_NEAR(newly_covered_area(curves), kPi * 9 / 2, 1e-12);
  }
}

TEST(LayeredArea, OfTheCapAboveALevelEdge) {
  RisingCurves curves = curves_in({-100, 1, 100, 100});
  append_disc({0, 0}, 2, Layer::kNew, curves);
  EXPECT_NEAR(newly_covered_area(curves), 4 * std::acos(0.5) - std::sqrt(3.0), 1e-12);
}

TEST(LayeredArea, OfTheLensOfTwoDiscs) {
  for (const double s : {3.0, 2.0, 1.1})
    for (const double angle : {0.0, 0.4, kPi / 2, 2.0}) {
      const double d = 0.5 * (3 + s);
      const Point other{d * std::cos(angle), d * std::sin(angle)};
      RisingCurves both;
      append_disc({0, 0}, 3, Layer::kBody, both);
      append_disc(other, s, Layer::kNew, both);
      EXPECT_NEAR(newly_covered_area(both), lens(3, s, d), 1e-12) << s << ", " << angle;

      RisingCurves crescent = curves_in();
      append_disc({0, 0}, 3, Layer::kCovered, crescent);
      append_disc(other, s, Layer::kNew, crescent);
      EXPECT_NEAR(newly_covered_area(crescent), kPi * s * s - lens(3, s, d), 1e-12) << s << ", " << angle;
    }
}

TEST(LayeredArea, OfDiscsThatTouchCoincideOrShareACentre) {
  // Of halves, so that some touch in the middle of a slab.
  const auto outside_taken = [](Point centre, double radius) {
    RisingCurves curves = curves_in();
    append_halves({0, 0}, 2, Layer::kCovered, curves);
    append_halves(centre, radius, Layer::kNew, curves);
    return newly_covered_area(curves);
  };
  EXPECT_NEAR(outside_taken({0, 0}, 2), 0, 1e-12);
  EXPECT_NEAR(outside_taken({0, 0}, 1), 0, 1e-12);
  EXPECT_NEAR(outside_taken({0, 0}, 3), 5 * kPi, 1e-12);
  for (const int sign : {-1, 1}) {
    EXPECT_NEAR(outside_taken({5. * sign, 0}, 3), 9 * kPi, 1e-12);
    EXPECT_NEAR(outside_taken({0, 5. * sign}, 3), 9 * kPi, 1e-12);
    EXPECT_NEAR(outside_taken({1. * sign, 0}, 1), 0, 1e-12);
    EXPECT_NEAR(outside_taken({0, 1. * sign}, 1), 0, 1e-12);
    EXPECT_NEAR(outside_taken({1. * sign, 0}, 3), 5 * kPi, 1e-12);
  }
}

TEST(LayeredArea, OfADiscThatTouchesLines) {
  for (const double by : {0.0, 0.1, -1.0 / 3}) {
    RisingCurves curves = curves_in({by - 2, -100, by + 2, 100});
    append_halves({by, 7}, 2, Layer::kNew, curves);
    EXPECT_NEAR(newly_covered_area(curves), 4 * kPi, 1e-6) << "between two lines";
    append_box({by + 2, -50, by + 5, 50}, Layer::kCovered, kEverywhere, curves);
    append_box({by - 9, 9, by + 9, 50}, Layer::kCovered, kEverywhere, curves);
    EXPECT_NEAR(newly_covered_area(curves), 4 * kPi, 1e-6) << "taken ground on two sides";
    append_ring({{by, 7}, {by + 2, 3}, {by + 2, 11}}, Layer::kCovered, kEverywhere, curves);
    EXPECT_LT(newly_covered_area(curves), 4 * kPi - 0.1);
  }
}

TEST(LayeredArea, OfABandIsItsWidthTimesItsLength) {
  for (const double width : {0.5, 2.0, 4.0}) {
    RisingCurves curves = curves_in();
    append_band(kS, width, Layer::kNew, curves);
    EXPECT_NEAR(newly_covered_area(curves), width * length(kS), 1e-12);
    // The machine may drive it the other way.
    curves = curves_in();
    append_band(reversed(kS), width, Layer::kNew, curves);
    EXPECT_NEAR(newly_covered_area(curves), width * length(kS), 1e-12);
  }
}

// Slanting ends, arcs of which y turns on the outer side only, a whole turn, a point instead of an arc.
TEST(LayeredArea, OfABandInAnyDirection) {
  for (int i = 0; i < 24; ++i) {
    const double angle = i * kPi / 12 + 0.01, c = std::cos(angle), s = std::sin(angle);
    const auto turn = [c, s](Point p) { return Point{c * p.x - s * p.y, s * p.x + c * p.y}; };
    for (const double width : {1.0, 4.0}) {
      RisingCurves curves = curves_in();
      append_band(moved(kS, turn), width, Layer::kNew, curves);
      EXPECT_NEAR(newly_covered_area(curves), width * length(kS), 1e-12) << i;
    }
    const Path circle{{{0, 0}, {-4, 0}, 0.5}, {{-4, 0}, {0, 0}, 0.5}};
    RisingCurves curves = curves_in();
    append_band(moved(circle, turn), 1, Layer::kNew, curves);
    // Half a circle given by chord and curvature knows its centre to √(1e-16) of its radius only.
    EXPECT_NEAR(newly_covered_area(curves), 4 * kPi, 1e-6) << i;
  }
}

TEST(LayeredArea, OfAnAlmostStraightArcIsThatOfALine) {
  for (const double curvature : {1e-5, 1e-8, -1e-11, 1e-14, -1e-300}) {
    RisingCurves curves = curves_in();
    append_band({{{0, 0}, {3, 40}, curvature}}, 2, Layer::kNew, curves);
    EXPECT_NEAR(newly_covered_area(curves), 2 * length(PathSegment{{0, 0}, {3, 40}, curvature}), 1e-9)
        << curvature;
    // A line beside it crosses it at both ends: between them lies the arc's segment.
    curves = curves_in();
    append_ring({{0, 0}, {3, 40}, {-20, 20}}, Layer::kCovered, kEverywhere, curves);
    append_ring({{3, 40}, {-20, 20}, {0, 0}}, Layer::kNew, kEverywhere, curves);
    EXPECT_NEAR(newly_covered_area(curves), 0, 1e-12);
  }
}

// The path's axis runs along the body's edge up to the turn, so half of the lower line counts, the
// ring sector inside the body (left of x = 0) of the first turn, and all of the rest.
TEST(LayeredArea, OfABandAcrossTheEdgeOfTheBody) {
  RisingCurves curves = curves_in({-100, -100, 0, 100});
  append_band(kS, 2, Layer::kNew, curves);
  // Between the circle of radius 3 about (−2, 0) and x = 0, in the upper half.
  const double beyond = 0.5 * (9 * std::acos(2.0 / 3) - 2 * std::sqrt(5.0));
  EXPECT_NEAR(newly_covered_area(curves), 2 * length(kS) - 3 - beyond, 1e-12);
}

TEST(LayeredArea, LeavesOutHolesOfTheBody) {
  RisingCurves curves = curves_in();
  append_ring(reversed(corners({-1, 0, 3, 5})), Layer::kBody, kEverywhere, curves);
  append_box({0, 1, 4, 10}, Layer::kNew, kEverywhere, curves);
  EXPECT_NEAR(newly_covered_area(curves), 36 - 12, 1e-12);
}

TEST(LayeredArea, CountsGroundInSeveralNewShapesOnce) {
  RisingCurves curves = curves_in();
  append_disc({0, 0}, 3, Layer::kNew, curves);
  append_disc({3, 0}, 3, Layer::kNew, curves);
  append_disc({0, 0}, 3, Layer::kNew, curves);
  append_disc({0.5, 0}, 1, Layer::kNew, curves);
  EXPECT_NEAR(newly_covered_area(curves), 18 * kPi - lens(3, 3, 3), 1e-12);
}

TEST(LayeredArea, LeavesOutWhatIsTaken) {
  RisingCurves curves = curves_in();
  append_box({0, 0, 10, 10}, Layer::kNew, kEverywhere, curves);
  append_box({0, 0, 2, 10}, Layer::kCovered, kEverywhere, curves);       // along the left edge
  append_box({2, 0, 4, 7}, Layer::kCovered, kEverywhere, curves);        // its neighbour
  append_box({3, 6, 5, 20}, Layer::kCovered, kEverywhere, curves);       // overlaps that one
  append_box({9, -10, 30, 10.5}, Layer::kCovered, kEverywhere, curves);  // out to the right
  // A square on its tip about (7, 5), half a diagonal of 1.
  append_ring({{7, 4}, {8, 5}, {7, 6}, {6, 5}}, Layer::kCovered, kEverywhere, curves);
  EXPECT_NEAR(newly_covered_area(curves), 100 - 20 - 14 - (8 - 1) - 10 - 2, 1e-12);
}

TEST(LayeredArea, NeighboursLeaveNoGapBetweenThem) {
  RisingCurves curves = curves_in();
  for (int i = 0; i < 7; ++i)
    append_box({i * 0.1, i % 2 * 0.3, (i + 1) * 0.1, 9.1}, Layer::kCovered, kEverywhere, curves);
  append_box({0, 0.3, 0.7, 9.1}, Layer::kNew, kEverywhere, curves);
  EXPECT_NEAR(newly_covered_area(curves), 0, 1e-14);
}

TEST(LayeredArea, WorksInTheWindowAsWithoutOne) {
  // A comb whose teeth lie left of, in, and right of the window, with steps on all sides of it.
  const Ring comb{{-30, -5}, {40, -6}, {38, 3},  {40, 20}, {9, 22},    {5, 1},   {4, 30},
                  {-9, 31},  {-6, 2},  {-12, 9}, {-15, 3}, {-25, 8.5}, {-40, 40}};
  const Box window{-4, 0, 12, 10};
  // The ring may begin anywhere.
  for (std::size_t first = 0; first < comb.size(); ++first) {
    Ring body = comb;
    std::rotate(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(first), body.end());
    RisingCurves all, within;
    append_ring(body, Layer::kBody, kEverywhere, all);
    append_ring(body, Layer::kBody, window, within);
    for (RisingCurves* curves : {&all, &within}) append_box({-4, 0, 12, 10}, Layer::kNew, window, *curves);
    EXPECT_GT(newly_covered_area(all), 10);
    EXPECT_NEAR(newly_covered_area(within), newly_covered_area(all), 1e-12);
    EXPECT_LT(within.size(), all.size());
    for (const RisingCurve& curve : within) {
      EXPECT_GE(curve.from.y, window.min_y);
      EXPECT_LE(curve.to.y, window.max_y);
      EXPECT_LE(std::min(curve.from.x, curve.to.x), window.max_x);
      if (std::max(curve.from.x, curve.to.x) < window.min_x) {
        EXPECT_EQ(curve.from.x, curve.to.x);
      }
    }
  }
}

TEST(LayeredArea, ChainsLeftOfTheWindowKeepTheWindingNumberOnly) {
  const Box window{0, 0, 10, 10};
  RisingCurves curves;
  append_ring({{-5, -5}, {-2, 3}, {-7, 2}, {-3, 20}, {-20, 20}, {-20, -5}}, Layer::kBody, window, curves);
  EXPECT_TRUE(curves.empty()) << "a ring that stays to the left";
  append_ring({{20, -5}, {20, 20}, {-3, 20}, {-7, 2}, {-2, 3}, {-5, -5}}, Layer::kBody, window, curves);
  ASSERT_EQ(curves.size(), 1U) << "a ring round the window";
  EXPECT_EQ(curves[0], (RisingCurve{{-1, 0}, {-1, 10}, 0, Layer::kBody, 1}));
}

TEST(LayeredArea, BoxesAreRingsOfTheirCorners) {
  const Box window{0, 0, 10, 10};
  const Box grounds[] = {{1, 1, 2, 2},     {-3, -3, 4, 4}, {-3, 2, 20, 4}, {-5, 0, -1, 9},
                         {8, -20, 12, 20}, {11, 0, 12, 9}, {2, 12, 3, 15}, {-5, -5, 15, 15}};
  for (const Box& ground : grounds) {
    RisingCurves by_box, by_ring;
    append_box(ground, Layer::kCovered, window, by_box);
    append_ring(corners(ground), Layer::kCovered, window, by_ring);
    EXPECT_EQ(by_box.size(), by_ring.size());
    for (const RisingCurve& curve : by_box)
      EXPECT_EQ(std::count(by_ring.begin(), by_ring.end(), curve), 1) << curve.from.x;
  }
}

TEST(LayeredArea, ClockwiseRingsTakeAway) {
  RisingCurves curves;
  append_ring(reversed(corners(kLargeBody)), Layer::kBody, kEverywhere, curves);
  append_box({0, 0, 1, 1}, Layer::kNew, kEverywhere, curves);
  EXPECT_EQ(newly_covered_area(curves), 0);
}

TEST(LayeredArea, PutsUpWithDegenerateShapes) {
  RisingCurves curves = curves_in();
  append_band({{{1, 1}, {1, 1}, 0}}, 2, Layer::kNew, curves);
  append_band({}, 2, Layer::kNew, curves);
  append_box({3, 3, 3, 5}, Layer::kNew, kEverywhere, curves);
  append_box(Box{}, Layer::kNew, kEverywhere, curves);
  append_ring({}, Layer::kNew, kEverywhere, curves);
  append_ring({{0, 0}}, Layer::kNew, kEverywhere, curves);
  append_ring({{0, 0}, {5, 5}}, Layer::kNew, kEverywhere, curves);
  append_ring({{0, 0}, {5, 5}, {5, 5}, {2, 2}, {0, 0}}, Layer::kCovered, kEverywhere, curves);
  append_ring(corners(kLargeBody), Layer::kBody, Box{}, curves);
  curves.push_back({{0, 0}, {0, 0}, 0, Layer::kNew, 1});
  curves.push_back({{0, 0}, {0, 0}, 0.5, Layer::kCovered, 1});
  EXPECT_NEAR(newly_covered_area(curves), 0, 1e-12);
  append_band({{{0, 0}, {0, 0}, 0}, {{0, 0}, {0, 4}, 0}, {{0, 4}, {0, 4}, 0.2}}, 2, Layer::kNew, curves);
  EXPECT_NEAR(newly_covered_area(curves), 8, 1e-12);
}

}  // namespace tramline::newly_covered_area_test
