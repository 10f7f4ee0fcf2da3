// The thesis' way round single obstacles, against its formulas, against the definition of its arcs by
// bisection, and against what ADR 5 says where it leaves a choice.

#include "tramline/avoidance/detour/versleijen_detour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "avoidance/pole_field.h"
#include "geometry/random_shapes.h"
#include "tramline/avoidance/detour/detour_frame.h"

namespace tramline::versleijen_detour_test {

using namespace testing_poles;

/// Thirteen strips of 160 m.
Ring wide_field(double width_m) { return box(0, 0, 13 * width_m, 160); }

/// The way past the only gap of one strip of that field.
WayRound way_in_strip(std::size_t strip, double width_m, double radius_m, const std::vector<Ring>& poles,
                      const VersleijenRule& rule, const std::vector<Ring>& passable = {}) {
  const Ring outer = wide_field(width_m);
  const PoleField field(outer, poles, machine(width_m, radius_m), {}, {}, passable);
  const StripGrid& grid = field.family().grid;
  return versleijen_detour({grid, field.family().tracks[strip], 1, radius_m}, rule,
                           turned_surroundings(field.ground(), outer, EdgeKind::kSoft, grid.frame));
}

/// In the seventh strip round a shape that no boolean has rounded to its grid. `pole`: what makes the gap.
WayRound way_round_exactly(double width_m, double radius_m, const Ring& pole, const TurnedHazard& shape,
                           const VersleijenRule& rule) {
  const Ring outer = wide_field(width_m);
  const PoleField field(outer, {pole}, machine(width_m, radius_m), {});
  const StripGrid& grid = field.family().grid;
  Surroundings around = turned_surroundings(field.ground(), outer, EdgeKind::kSoft, grid.frame);
  around.hazards = {shape};
  return versleijen_detour({grid, field.family().tracks[6], 1, radius_m}, rule, around);
}
TurnedHazard exact_circle(const Ring& pole, Point centre, double radius_m) {
  return {pole, bounds(pole), Circle{centre, radius_m}};
}

/// The same of the seventh strip: with strips of 3 m its centre line is x = 19.5.
WayRound way_in_field(double width_m, double radius_m, const std::vector<Ring>& poles,
                      const VersleijenRule& rule, const std::vector<Ring>& passable = {}) {
  return way_in_strip(6, width_m, radius_m, poles, rule, passable);
}

VersleijenRule below(double threshold_m) { return {.threshold_m = threshold_m}; }
VersleijenRule drivable_below(double threshold_m) {
  return {.threshold_m = threshold_m, .middle = DetourMiddle::kDrivable};
}

/// Largest distance of the path from the track's line.
double peak_of(const WayRound& way, double centre) {
  double most = 0;
  for (const PathSegment& segment : way.detour.path)
    for (const Point p : chords({segment})) most = std::max(most, std::abs(p.x - centre));
  return most;
}

/// Whether the middle is that of the thesis, ρ = R + w/2, or our max(ρ, r).
double pass_radius(DetourMiddle middle, double obstacle, double width, double radius) {
  const double buffer = obstacle + width / 2;
  return middle == DetourMiddle::kAsPrinted ? buffer : std::max(buffer, radius);
}

// Fig. 18: three arcs of the radii r, ρ and r, and ends √((ρ + r)² − (r ± c)²) before and behind, with +
// where the circle's centre lies on the other side of the track. R lies below and above r − w/2.
TEST(VersleijenDetour, RoundACircleHasTheArcsAndTheLengthOfTheFormula) {
  for (const DetourMiddle middle : {DetourMiddle::kAsPrinted, DetourMiddle::kDrivable})
    for (const double width : {3.0, 6.0})
      for (const double radius : {3.0, 6.0, 9.0, 12.0})
        for (const double obstacle : {0.3, 1.2, 5.0, 12.0})
          for (const double off : {-0.6, -0.2, 0.3}) {
            SCOPED_TRACE(::testing::Message()
                         << "w " << width << " r " << radius << " R " << obstacle << " off " << off);
            const double centre = 6.5 * width;
            if (obstacle + width / 2 > centre - width) continue;  // it would leave the field
            const Point at{centre + off, 80};
            const Ring pole = regular(64, obstacle, at);
            const WayRound way = way_round_exactly(width, radius, pole, exact_circle(pole, at, obstacle),
                                                   {.threshold_m = 100, .middle = middle});
            ASSERT_TRUE(way.possible()) << sentence(way.why_not);
            // The side with the smaller displacement is that from which the centre lies away.
            EXPECT_EQ(way.detour.side, off > 0 ? Passing::kLeft : Passing::kRight);
            const double pass = pass_radius(middle, obstacle, width, radius), arm = radius + std::abs(off);
            const double half = std::sqrt((pass + radius) * (pass + radius) - arm * arm);
            EXPECT_NEAR(way.detour.from, 80 - half, 1e-9);
            EXPECT_NEAR(way.detour.to, 80 + half, 1e-9);
            ASSERT_GE(way.detour.path.size(), 3u);
            EXPECT_NEAR(tramline::radius(way.detour.path.front()), radius, 1e-9);
            EXPECT_NEAR(tramline::radius(way.detour.path[1]), pass, 1e-9);
            EXPECT_NEAR(tramline::radius(way.detour.path.back()), radius, 1e-9);
            const Point middle_centre = tramline::centre(way.detour.path[1]);
            const double beside = pass - std::abs(off);
            EXPECT_NEAR(std::abs(middle_centre.x - centre) + beside, pass, 1e-9);
            EXPECT_EQ(way.hazards, std::vector<std::size_t>{0});
            EXPECT_EQ(way.first_gap, 1u);
            EXPECT_EQ(way.last_gap, 1u);
            EXPECT_NEAR(way.detour.length_m, length(way.detour.path), 1e-9);
          }
}

// Table 3 and fig. 37 at w = 3 and r = 6: a mast of 1.2 m is passed at 2.7 m, whatever the machine's radius.
TEST(VersleijenDetour, PassesAMastAtItsRadiusAndHalfTheWidth) {
  for (const double radius : {3.0, 6.0, 9.0, 12.0}) {
    const Ring mast = regular(64, 1.2, {19.5, 80});
    const WayRound way = way_round_exactly(3, radius, mast, exact_circle(mast, {19.5, 80}, 1.2), below(3));
    ASSERT_TRUE(way.possible()) << sentence(way.why_not);
    EXPECT_NEAR(peak_of(way, 19.5), 2.7, 1e-2 + 1e-9) << "chords lie up to 1 cm inside";
    EXPECT_NEAR(smallest_radius(way.detour.path), 2.7, 1e-9);
  }
}

// Fig. 50 (a): the thesis' program never came nearer than w/2 to the neighbour's line.
TEST(VersleijenDetour, LeavesTheTrackNoFartherThanItMay) {
  const std::vector<Ring> mast{regular(64, 1.2, {19.5 + 1.2, 80})};  // to be passed at 1.5 m
  EXPECT_TRUE(way_in_field(3, 6, mast, {.threshold_m = 3, .room_m = 1.50001}).possible());
  EXPECT_EQ(way_in_field(3, 6, mast, {.threshold_m = 3, .room_m = 1.499}).why_not, Refusal::kNoRoomBeside);
  EXPECT_EQ(way_in_field(3, 6, {regular(64, 1.2, {19.5, 80})}, {.threshold_m = 3, .room_m = 1.5}).why_not,
            Refusal::kNoRoomBeside);
}

/// Distance of a point to a polygon's outline, by its edges.
double off_outline(const Ring& ring, Point p) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], edge = ring[(i + 1) % ring.size()] - a;
    const double share = std::clamp(dot(p - a, edge) / dot(edge, edge), 0.0, 1.0);
    out = std::min(out, distance(p, a + share * edge));
  }
  return out;
}

Ring hull_of(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x; });
  Ring out;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = out.size();
    for (const Point p : points) {
      while (out.size() >= begin + 2 && cross(out.back() - out[out.size() - 2], p - out.back()) <= 0)
        out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return out;
}

/// Where on the track, going away from the obstacle, a circle of radius r beside it last touches the buffer
/// of w/2: by steps and bisection.
double last_touch(const Ring& hull, double radius, double width, double beside, double from, double step) {
  const double reach = radius + width / 2;
  const auto off = [&](double along) { return off_outline(hull, {beside, along}) - reach; };
  double far = from + step * 2000;
  while (off(far) > 0) far -= step;
  double near = far;
  far += step;
  for (int i = 0; i < 100; ++i) (off(0.5 * (near + far)) > 0 ? far : near) = 0.5 * (near + far);
  return 0.5 * (near + far);
}

// Fig. 19: arcs of radius r that touch track and buffer, and between them the buffer's edge. The ends by
// bisection on the distance between circle and obstacle; the middle by its distance of w/2. A bay is passed
// as if it were filled up.
TEST(VersleijenDetour, RoundAPolygonTouchesItsBufferAndFollowsIt) {
  int bays = 0;
  for (int number = 0; number < 300; ++number) {
    testing::RandomCase random(number);
    const double width = 3, radius = random.between(3, 12), centre = 6.5 * width;
    Ring ring =
        testing::random_star(random, {centre + random.between(-1, 1), 80}, 0.3, 1.4, random.whole(4, 7));
    const Ring hull = hull_of(ring);
    bays += hull.size() < ring.size() ? 1 : 0;
    const WayRound way = way_round_exactly(width, radius, ring, {ring, bounds(ring), {}}, below(3));
    if (way.why_not == Refusal::kNoSide) continue;  // it only touches the strip
    ASSERT_TRUE(way.possible()) << sentence(way.why_not);
    const double side = way.detour.side == Passing::kLeft ? -1 : 1;
    const double beside = centre + side * radius;
    EXPECT_NEAR(way.detour.to, last_touch(hull, radius, width, beside, 80, 0.01), 1e-8);
    EXPECT_NEAR(way.detour.from, last_touch(hull, radius, width, beside, 80, -0.01), 1e-8);
    const Path& path = way.detour.path;
    ASSERT_GE(path.size(), 2u);
    EXPECT_NEAR(tramline::radius(path.front()), radius, 1e-9);
    EXPECT_NEAR(tramline::radius(path.back()), radius, 1e-9);
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      EXPECT_NEAR(off_outline(hull, path[i].from), width / 2, 1e-9);
      EXPECT_NEAR(off_outline(hull, path[i].to), width / 2, 1e-9);
      if (!path[i].straight()) {
        EXPECT_NEAR(tramline::radius(path[i]), width / 2, 1e-9);
      }
    }
  }
  EXPECT_GT(bays, 50);
}

TEST(VersleijenDetour, IsOnTheLeftWhereBothSidesAreEqual) {
  const WayRound way = way_in_field(3, 6, {regular(16, 1, {19.5, 80})}, below(3));
  ASSERT_TRUE(way.possible());
  EXPECT_EQ(way.detour.side, Passing::kLeft);
}

// Fig. 19, along the buffer of w/2. A box from 0.3 m left to 0.7 m right of the track, 4 m long: the path
// is 1.5 + 0.3 m off between its corners' arcs of 1.5 m, and with r = w/2 the ends lie √(3² − 1.2²) beyond.
TEST(VersleijenDetour, RoundABoxFollowsItsBuffer) {
  const WayRound way = way_in_field(3, 1, {box(19.2, 78, 20.2, 82)}, below(3));
  ASSERT_TRUE(way.possible()) << sentence(way.why_not);
  EXPECT_EQ(way.detour.side, Passing::kLeft);
  const double beyond = std::sqrt(9 - 1.2 * 1.2);
  EXPECT_NEAR(way.detour.from, 78 - beyond, 1e-6);
  EXPECT_NEAR(way.detour.to, 82 + beyond, 1e-6);
  EXPECT_NEAR(peak_of(way, 19.5), 1.8, 1e-6);
  EXPECT_NEAR(way.detour.length_m, 4 + 2 * 3 * std::acos(1.2 / 3), 1e-6);
}

// Corners of w/2 are too tight for a machine that turns on more (§4.2.2): drawn as printed, refused where the
// detour is to be driven.
TEST(VersleijenDetour, IsTighterThanTheMachineTurnsUnlessItIsToBeDriven) {
  const std::vector<Ring> post{box(19.2, 78, 20.2, 82)};
  EXPECT_EQ(way_in_field(3, 1.6, post, drivable_below(3)).why_not, Refusal::kTooTight);
  const WayRound printed = way_in_field(3, 1.6, post, below(3));
  ASSERT_TRUE(printed.possible());
  EXPECT_NEAR(smallest_radius(printed.detour.path), 1.5, 1e-9);
}

// (a) The extent across has to be below the threshold, not equal to it.
TEST(VersleijenDetour, IsRefusedFromTheThresholdOn) {
  const std::vector<Ring> two_wide{box(18.5, 79, 20.5, 81)};
  EXPECT_EQ(way_in_field(3, 1, two_wide, below(2)).why_not, Refusal::kTooWide);
  EXPECT_EQ(way_in_field(3, 1, two_wide, below(1)).why_not, Refusal::kTooWide);
  EXPECT_TRUE(way_in_field(3, 1, two_wide, below(2.001)).possible());
}

// The arrow's bay faces along the track: its hull is what the path goes round.
TEST(VersleijenDetour, GoesRoundABayAsIfItWereFilledUp) {
  const Ring arrow{{19, 78}, {19.5, 79}, {20, 78}, {19.5, 82}}, filled{{19, 78}, {20, 78}, {19.5, 82}};
  const WayRound way = way_in_field(3, 1, {arrow}, drivable_below(3));
  ASSERT_TRUE(way.possible()) << sentence(way.why_not);
  const WayRound same = way_in_field(3, 1, {filled}, drivable_below(3));
  EXPECT_NEAR(way.detour.from, same.detour.from, 1e-6);
  EXPECT_NEAR(way.detour.to, same.detour.to, 1e-6);
  EXPECT_NEAR(way.detour.length_m, same.detour.length_m, 1e-6);
}

// Only what reaches into the strip counts.
TEST(VersleijenDetour, IsRefusedUnlessThereIsOneObstacle) {
  const Ring outer = wide_field(3);
  const PoleField field(outer, {regular(16, 1, {19.6, 80})}, machine(3, 6), {});
  const StripGrid& grid = field.family().grid;
  const Obstruction obstruction{grid, field.family().tracks[6], 1, 6};
  Surroundings around = turned_surroundings(field.ground(), outer, EdgeKind::kSoft, grid.frame);
  const auto with = [&around](const Ring& ring) {
    Surroundings out = around;
    out.hazards.push_back({ring, bounds(ring), {}});
    return out;
  };
  EXPECT_TRUE(versleijen_detour(obstruction, below(3), with(box(25, 79, 26, 81))).possible());
  const WayRound two = versleijen_detour(obstruction, below(3), with(box(18.2, 79.8, 18.3, 80.2)));
  EXPECT_EQ(two.why_not, Refusal::kSeveralObstacles);
  EXPECT_EQ(two.hazards, (std::vector<std::size_t>{0, 1}));
  around.hazards.clear();
  EXPECT_FALSE(versleijen_detour(obstruction, below(3), around).possible());
}

// The path leaves the track √((2.5 + 12)² − 12.1²) = 7.99 m before a pole of 1 m, 0.1 m left of the track, to
// the right. 4 m before the pole it is 12 − √(12² − 3.99²) = 0.68 m off, so that its swath works to x
// = 21.68.
TEST(VersleijenDetour, IsRefusedWhereItMeetsAnotherObstacle) {
  const Ring first = regular(16, 1, {19.4, 80});
  EXPECT_EQ(way_in_field(3, 12, {first, regular(16, 0.5, {22, 76})}, below(3)).why_not,
            Refusal::kMeetsObstacle);
  EXPECT_TRUE(way_in_field(3, 12, {first, regular(16, 0.5, {22.5, 76})}, below(3)).possible());
}

// The field begins at y = 0. Ends lie √((2.5 + 12)² − 12.1²) = 7.99 m before the obstacle's centre.
TEST(VersleijenDetour, IsRefusedWhereTheTrackEndsBefore) {
  EXPECT_EQ(way_in_field(3, 12, {regular(16, 1, {19.4, 7.9})}, below(3)).why_not,
            Refusal::kVersleijenEndsBefore);
  EXPECT_TRUE(way_in_field(3, 12, {regular(16, 1, {19.4, 8.1})}, below(3)).possible());
}

// The same path mirrored is 0.68 m left of the track 4 m before the pole: at x = 18.82.
TEST(VersleijenDetour, IsRefusedWhereItLeavesTheField) {
  const Ring pole = regular(16, 1, {19.6, 80}), outer = wide_field(3);
  const PoleField field(outer, {pole}, machine(3, 12), {});
  const StripGrid& grid = field.family().grid;
  const auto beside_a_bay_to = [&](double x) {
    const Ring with_bay{{0, 0}, {39, 0}, {39, 160}, {0, 160}, {0, 76}, {x, 76}, {x, 74}, {0, 74}};
    const Surroundings around = turned_surroundings(field.ground(), with_bay, EdgeKind::kSoft, grid.frame);
    return versleijen_detour({grid, field.family().tracks[6], 1, 12}, below(3), around);
  };
  EXPECT_EQ(beside_a_bay_to(18.9).detour.side, Passing::kLeft);
  EXPECT_EQ(beside_a_bay_to(18.9).why_not, Refusal::kLeavesField);
  EXPECT_TRUE(beside_a_bay_to(18.7).possible());
}

// Passable land 2.5 m beside the track would be worked on the way.
TEST(VersleijenDetour, IsRefusedWhereItEntersPassableLand) {
  const Ring ditch = box(22, 70, 22.5, 90);
  EXPECT_EQ(way_in_field(3, 6, {regular(16, 1, {19.2, 80})}, below(3), {ditch}).why_not,
            Refusal::kEntersPassable);
  EXPECT_TRUE(way_in_field(3, 6, {regular(16, 1, {19.8, 80})}, below(3), {ditch}).possible())
      << "on the other side";
}

}  // namespace tramline::versleijen_detour_test
