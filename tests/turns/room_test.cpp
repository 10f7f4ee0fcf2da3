// Room for turns, on land drawn by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tramline/turns/outline/swept_reach.h"
#include "tramline/turns/room/allowed_land.h"
#include "tramline/turns/room/part_sweep.h"
#include "tramline/turns/room/places_off.h"

namespace tramline::room_test {

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 6;
const Pose kNorthwards{{0, 0}, Heading::clockwise_from_north(Angle::degrees(0))};

Polygon rectangle(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

Machine bar(double width_m, double behind_m = 0) {
  Machine out;
  out.width_m = width_m;
  out.turning.implement_offset_m = behind_m;
  return out;
}

SteeredPath joined(const Pose& start, const std::vector<std::array<double, 2>>& stretches) {
  SteeredPath out;
  Pose at = start;
  for (const auto& [length, curvature] : stretches) {
    out.push_back(arc_from(at, length, curvature, Gear::kForward));
    at = end_of(out.back());
  }
  return out;
}

/// Out to the right, round to the left, back to the right: to a track `width` to the left.
SteeredPath omega(double width_m) {
  const double out = std::acos((2 * kRadius + width_m) / (4 * kRadius));
  const double k = 1 / kRadius;
  return joined(kNorthwards, {{kRadius * out, -k}, {kRadius * (kPi + 2 * out), k}, {kRadius * out, -k}});
}

SteeredPath half_circle() { return joined(kNorthwards, {{kRadius * kPi, 1 / kRadius}}); }

TEST(Room, OfAHalfCircleIsItsOuterRadius) {
  // The bar's outer rear corner is 12 m beside the centre and 2 m behind it.
  const Outline outline = outline_of(bar(12, 2));
  const double outer = std::hypot(12, 2);
  const auto fits_in = [&](double top, double right) {
    return AllowedLand({rectangle(-40, -30, -6 + right, top)}).fits(half_circle(), outline);
  };
  EXPECT_TRUE(fits_in(20, 20));
  EXPECT_TRUE(fits_in(outer, outer)) << "it may touch";
  EXPECT_FALSE(fits_in(outer - 1e-5, outer));
  EXPECT_FALSE(fits_in(outer, outer - 1e-5));
}

TEST(Room, OfAnOmegaIsItsReachOnEverySide) {
  for (const double behind : {0.0, 2.5, -1.5}) {
    const Outline outline = outline_of(bar(9, behind));
    const auto reach = [&](Point to) { return swept_reach_m(omega(6), outline, {0, 0}, to); };
    const double west = reach({-1, 0}), east = reach({1, 0}), south = reach({0, -1}), north = reach({0, 1});
    EXPECT_TRUE(AllowedLand({rectangle(-west, -south, east, north)}).fits(omega(6), outline));
    const double less = 3e-6;
    EXPECT_FALSE(AllowedLand({rectangle(-west + less, -south, east, north)}).fits(omega(6), outline));
    EXPECT_FALSE(AllowedLand({rectangle(-west, -south + less, east, north)}).fits(omega(6), outline));
    EXPECT_FALSE(AllowedLand({rectangle(-west, -south, east - less, north)}).fits(omega(6), outline));
    EXPECT_FALSE(AllowedLand({rectangle(-west, -south, east, north - less)}).fits(omega(6), outline));
  }
}

/// Behind the axle the bar swings out at the start of the turn, in front of it at the end.
TEST(Room, DependsOnTheSenseInWhichThePathIsDriven) {
  const SteeredPath quarter = joined(kNorthwards, {{0.5 * kPi * kRadius, 1 / kRadius}});
  const Outline outline = outline_of(bar(12, 3));
  const double outer = std::hypot(12, 3);
  // Eastwards of the start: from the centre at −6 only one sense gets beyond 12 m.
  const AllowedLand land({rectangle(-40, -20, -6 + 12.1, 30)});
  EXPECT_GT(outer, 12.1);
  EXPECT_FALSE(land.fits(quarter, outline));
  EXPECT_TRUE(land.fits(turned_round(quarter), outline));
}

TEST(Room, APylonOrASpikeBetweenTheEndsOfABarIsFound) {
  const Outline outline = outline_of(bar(24));
  const SteeredPath turn = half_circle();
  Polygon land = rectangle(-60, -60, 60, 60);
  EXPECT_TRUE(AllowedLand({land}).fits(turn, outline));
  int met = 0, passed = 0;
  // Pylons of 0.2 m on a grid: those within the circles of the bar's ends about (−6, 0), 18 and 6 m, on the
  // side that each half goes round.
  for (double x = -30; x <= 20; x += 1.7)
    for (double y = -20; y <= 20; y += 1.7) {
      Polygon with = land;
      with.holes.push_back(reversed(rectangle(x - 0.1, y - 0.1, x + 0.1, y + 0.1).outer));
      const double from_centre = std::hypot(x + 6, y);
      const bool swept = y > 0 ? from_centre < 18 : from_centre < 6;
      const bool close =
          std::abs(from_centre - 18) < 0.2 || std::abs(from_centre - 6) < 0.2 || std::abs(y) < 0.2;
      if (close) continue;
      EXPECT_EQ(AllowedLand({with}).fits(turn, outline), !swept) << x << " " << y;
      ++(swept ? met : passed);
    }
  EXPECT_GT(met, 150);
  EXPECT_GT(passed, 150);
  // A spike from the north, 0.1 m wide at its base, that ends between the ends of the bar.
  const auto spiked = [](double tip) {
    return Polygon{{{-60, -60}, {60, -60}, {60, 60}, {-0.95, 60}, {-1, tip}, {-1.05, 60}, {-60, 60}}, {}};
  };
  const double top = std::sqrt(18.0 * 18 - 5 * 5);
  EXPECT_TRUE(AllowedLand({spiked(top + 0.001)}).fits(turn, outline));
  EXPECT_FALSE(AllowedLand({spiked(top - 0.01)}).fits(turn, outline));
  EXPECT_FALSE(AllowedLand({spiked(3)}).fits(turn, outline));
}

TEST(Room, ABarOnAHardEdgeMayLeaveItButNotCrossIt) {
  const Outline outline = outline_of(bar(12));
  const SteeredPath away = joined(kNorthwards, {{3, 0}, {kRadius * kPi, 1 / kRadius}, {3, 0}});
  // the bar stands on the southern edge, and its right end touches the eastern one
  EXPECT_TRUE(AllowedLand({rectangle(-40, 0, 6, 40)}).fits(away, outline));
  EXPECT_FALSE(AllowedLand({rectangle(-40, 0, 6 - 1e-5, 40)}).fits(away, outline));
  EXPECT_FALSE(AllowedLand({rectangle(-40, 1e-5, 6, 40)}).fits(away, outline));
  EXPECT_FALSE(
      AllowedLand({rectangle(-40, 0, 6, 40)}).fits(retraced(joined(kNorthwards, {{3, -0.1}})), outline));
}

TEST(Room, OfABehindBarThatSwingsOutIsMissingBesideAHardEdge) {
  const AllowedLand land({rectangle(-40, -10, 6, 40)});
  EXPECT_FALSE(land.fits(half_circle(), outline_of(bar(12, 3))));
  EXPECT_NEAR(land.missing_m(half_circle(), outline_of(bar(12, 3))), std::hypot(12, 3) - 12, 0.02);
}

// Along 1.7 km the bar is a centimetre over the edge; where it begins its end is past a slanting edge, the
// line y = x − 17.69, by (18 − 17.69)/√2.
TEST(Room, IsMissingWhereALongWayBeginsMoreThanAlongIt) {
  const AllowedLand land({{{{-40, -30}, {-12.31, -30}, {17.99, 0.3}, {17.99, 1800}, {-40, 1800}}, {}}});
  const SteeredPath straight = joined(kNorthwards, {{1700, 0}});
  EXPECT_NEAR(land.missing_m(straight, outline_of(bar(36))), 0.31 / std::numbers::sqrt2, 0.02);
  EXPECT_NEAR(land.missing_m(retraced(straight), outline_of(bar(36))), 0.31 / std::numbers::sqrt2, 0.02);
}

TEST(Room, OutsideTheLandThereIsNone) {
  const AllowedLand land({rectangle(100, 100, 200, 200)});
  EXPECT_FALSE(land.fits(half_circle(), outline_of(bar(12))));
  EXPECT_GT(land.missing_m(half_circle(), outline_of(bar(12))), 100);
  EXPECT_TRUE(land.fits({}, outline_of(bar(12))));
  EXPECT_FALSE(AllowedLand({}).fits(half_circle(), outline_of(bar(12))));
  EXPECT_TRUE(std::isinf(AllowedLand({}).missing_m(half_circle(), outline_of(bar(12)))));
}

TEST(Room, InsideAHoleThereIsNone) {
  Polygon land = rectangle(-100, -100, 100, 100);
  land.holes.push_back(reversed(rectangle(-50, -50, 50, 50).outer));
  EXPECT_FALSE(AllowedLand({land}).fits(half_circle(), outline_of(bar(12))));
}

TEST(Room, AFullCircleLeavesItsMiddleAlone) {
  Polygon land = rectangle(-100, -100, 100, 100);
  const SteeredPath circle = joined(kNorthwards, {{2 * kPi * kRadius + 5, 1 / kRadius}});
  const auto with_disc = [&](double radius) {
    Polygon out = land;
    Ring ring;
    for (int i = 0; i < 60; ++i)
      ring.push_back({-6 + radius * std::cos(i * kPi / 30), radius * std::sin(i * kPi / 30)});
    out.holes.push_back(reversed(ring));
    return AllowedLand({out});
  };
  EXPECT_TRUE(with_disc(2.999).fits(circle, outline_of(bar(6))));
  EXPECT_FALSE(with_disc(3.1).fits(circle, outline_of(bar(6))));
  // in front of the axle the bar's line touches a circle of 3 m; its inner end is farther away
  EXPECT_TRUE(with_disc(std::hypot(3, 2) - 0.01).fits(circle, outline_of(bar(6, -2))));
  EXPECT_FALSE(with_disc(std::hypot(3, 2) + 0.03).fits(circle, outline_of(bar(6, -2))));
  EXPECT_TRUE(with_disc(1.99).fits(circle, outline_of(bar(14, -2))));
  EXPECT_FALSE(with_disc(2.03).fits(circle, outline_of(bar(14, -2))));
}

TEST(Room, ATowedBarCutsTheCornerAndSwingsWide) {
  Machine machine = bar(12);
  machine.turning.implement = Coupling::kTowed;
  machine.turning.implement_offset_m = 1;
  machine.turning.drawbar_m = 5;
  const Outline outline = outline_of(machine);
  const SteeredPath turn = joined(kNorthwards, {{2, 0}, {kRadius * kPi, 1 / kRadius}, {15, 0}});
  for (const Point to : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}}) {
    const double reach = swept_reach_m(turn, outline, {0, 0}, to);
    const Point side = left_of(to);
    const auto land_to = [&](double far) {
      return AllowedLand(
          {{{far * to - 90 * side, far * to + 90 * side, -90 * to + 90 * side, -90 * to - 90 * side}, {}}});
    };
    EXPECT_TRUE(land_to(reach).fits(turn, outline)) << "it may touch";
    EXPECT_FALSE(land_to(reach - 2.5e-3).fits(turn, outline));
    EXPECT_NEAR(land_to(reach - 1).missing_m(turn, outline), 1, 0.021);
  }
}

// What rounding leaves of an arc, about 1e-16 m, has no centre to compute with: edges that the part does not
// touch where it stands are not met.
TEST(PartSweep, OfNextToNoMotionIsThePart) {
  const Box part{-0.5, -4.5, 6, 4.5};
  for (const double way : {0.0, 3.4e-16, -2e-13, 1e-11})
    for (const double turn : {5.6e-17, -5.6e-17, 3e-15, -1e-12, 1e-10}) {
      const PartSweep sweep(part, {placed(kNorthwards), way, turn});
      EXPECT_TRUE(sweep.meets({2, -9}, {3, 9}));
      for (const double off_m : {1e-6, 0.1, 3.0, 40.0}) {
        EXPECT_FALSE(sweep.meets({6 + off_m, -70}, {6 + off_m, 80})) << way << " " << turn;
        EXPECT_FALSE(sweep.meets({-0.5 - off_m, -70}, {-0.5 - off_m, 80})) << way << " " << turn;
        EXPECT_FALSE(sweep.meets({-60, 4.5 + off_m}, {90, 4.5 + off_m})) << way << " " << turn;
        EXPECT_FALSE(sweep.meets({-60, -4.5 - off_m}, {90, -4.5 - off_m})) << way << " " << turn;
      }
    }
}

// The axle itself, on a quarter circle of 6 m: it passes 6 m (1 − cos 45°) beside its heading half-way.
TEST(PartSweep, OfAPointIsItsWay) {
  const PartSweep sweep({0, 0, 0, 0}, {placed(kNorthwards), 3 * kPi, 0.5 * kPi});
  const double x = 6 * std::sin(0.25 * kPi), y = 6 * (1 - std::cos(0.25 * kPi));
  EXPECT_TRUE(sweep.meets({x, y - 1}, {x, y + 1}));
  EXPECT_FALSE(sweep.meets({x, -1}, {x, y - 1e-6}));
  EXPECT_FALSE(sweep.meets({7, -1}, {7, 1})) << "where it would be had it gone straight on";
}

// A bar of 4 m driven north out of a field that ends 5 m ahead, and past a pole on its right.
TEST(PlacesOff, AreThoseBeyondTheEdges) {
  Polygon field = rectangle(-10, -1, 10, 5);
  field.holes.push_back({{1.4, 2.9}, {1.4, 3.1}, {1.6, 3.1}, {1.6, 2.9}});
  const AllowedLand land({field});
  const SteeredPath path = joined(kNorthwards, {{6, 0}});
  int beyond = 0, on_pole = 0;
  for (const Point p : places_off(land.edges(), path, outline_of(bar(4)), 0.1)) {
    const bool beyond_edge = p.y > 5 - 1e-6;
    beyond += beyond_edge ? 1 : 0;
    on_pole += beyond_edge ? 0 : 1;
    EXPECT_LE(std::abs(p.x), 2 + 1e-9);
    if (!beyond_edge) {
      EXPECT_NEAR(std::max(std::abs(p.x - 1.5), std::abs(p.y - 3)), 0, 0.1 + 1e-9);
    }
  }
  EXPECT_GT(beyond, 100);
  EXPECT_GT(on_pole, 0);
  EXPECT_TRUE(places_off(land.edges(), joined(kNorthwards, {{2.5, 0}}), outline_of(bar(4)), 0.1).empty());
}

}  // namespace tramline::room_test
