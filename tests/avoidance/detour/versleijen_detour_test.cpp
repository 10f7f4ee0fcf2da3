// Versleijen's way round single obstacles, against the formulas of the thesis and what ADR 5 says where it
// leaves a choice.

#include "tramline/avoidance/detour/versleijen_detour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "avoidance/pole_field.h"

namespace tramline {
namespace {

using namespace testing_poles;

/// Thirteen strips of 160 m.
Ring wide_field(double width_m) { return rectangle(0, 0, 13 * width_m, 160); }

/// The way past the only gap of one strip of that field.
WayRound way_in_strip(std::size_t strip, double width_m, double radius_m, const std::vector<Ring>& poles,
                      double threshold_m, const std::vector<Ring>& passable = {}) {
  const Ring outer = wide_field(width_m);
  const PoleField field(outer, poles, machine(width_m, radius_m), {}, {}, passable);
  const StripGrid& grid = field.family().grid;
  return versleijen_detour({grid, field.family().tracks[strip], 1, radius_m}, threshold_m,
                           turned_surroundings(field.ground(), outer, EdgeKind::kSoft, grid.frame));
}

/// The same of the seventh strip: with strips of 3 m its centre line is x = 19.5.
WayRound way_in_field(double width_m, double radius_m, const std::vector<Ring>& poles, double threshold_m,
                      const std::vector<Ring>& passable = {}) {
  return way_in_strip(6, width_m, radius_m, poles, threshold_m, passable);
}

/// Largest distance of the path from the track's line.
double peak_of(const WayRound& way, double centre) {
  double most = 0;
  for (const PathSegment& segment : way.detour.path)
    for (const Point p : chords({segment})) most = std::max(most, std::abs(p.x - centre));
  return most;
}

// Versleijen fig. 18, drivable: a pass radius ρ = max(R_o + w/2, r), and ends √((ρ + r)² − (r ± c)²) before
// and behind, with + where the circle's centre lies on the other side of the track.
TEST(VersleijenDetour, RoundACircleHasThePassRadiusAndTheLengthOfTheFormula) {
  for (const double width : {3.0, 6.0})
    for (const double radius : {3.0, 6.0, 12.0})
      for (const double obstacle : {0.3, 1.0})
        for (const double off : {-0.6, -0.2, 0.3}) {
          SCOPED_TRACE(::testing::Message()
                       << "w " << width << " r " << radius << " R " << obstacle << " off " << off);
          const double centre = 6.5 * width;
          const WayRound way =
              way_in_field(width, radius, {regular(16, obstacle, {centre + off, 80})}, width);
          ASSERT_TRUE(way.possible()) << sentence(way.why_not);
          // The side with the smaller displacement is that from which the centre lies away.
          EXPECT_EQ(way.detour.side, off > 0 ? Passing::kLeft : Passing::kRight);
          const double pass = std::max(obstacle + width / 2, radius), arm = radius + std::abs(off);
          const double half = std::sqrt((pass + radius) * (pass + radius) - arm * arm);
          EXPECT_NEAR(way.detour.from, 80 - half, 1e-6);
          EXPECT_NEAR(way.detour.to, 80 + half, 1e-6);
          EXPECT_NEAR(peak_of(way, centre), pass - std::abs(off), 1e-4);
          EXPECT_EQ(way.hazards, std::vector<std::size_t>{0});
          EXPECT_EQ(way.first_gap, 1u);
          EXPECT_EQ(way.last_gap, 1u);
          EXPECT_NEAR(way.detour.length_m, length(way.detour.path), 1e-9);
        }
}

TEST(VersleijenDetour, IsOnTheLeftWhereBothSidesAreEqual) {
  const WayRound way = way_in_field(3, 6, {regular(16, 1, {19.5, 80})}, 3);
  ASSERT_TRUE(way.possible());
  EXPECT_EQ(way.detour.side, Passing::kLeft);
}

// Versleijen fig. 19: along the buffer of w/2. A box from 0.3 m left to 0.7 m right of the track, 4 m long:
// the path is 1.5 + 0.3 m off between its corners' arcs of 1.5 m, and with r = w/2 the ends lie √(3² − 1.2²)
// beyond.
TEST(VersleijenDetour, RoundABoxFollowsItsBuffer) {
  const WayRound way = way_in_field(3, 1, {rectangle(19.2, 78, 20.2, 82)}, 3);
  ASSERT_TRUE(way.possible()) << sentence(way.why_not);
  EXPECT_EQ(way.detour.side, Passing::kLeft);
  const double beyond = std::sqrt(9 - 1.2 * 1.2);
  EXPECT_NEAR(way.detour.from, 78 - beyond, 1e-6);
  EXPECT_NEAR(way.detour.to, 82 + beyond, 1e-6);
  EXPECT_NEAR(peak_of(way, 19.5), 1.8, 1e-6);
  EXPECT_NEAR(way.detour.length_m, 4 + 2 * 3 * std::acos(1.2 / 3), 1e-6);
}

// Versleijen §4.2.2: corners of w/2 are too tight for a machine that turns on more.
TEST(VersleijenDetour, IsRefusedWhereTheBufferIsTighterThanTheMachineTurns) {
  EXPECT_EQ(way_in_field(3, 1.6, {rectangle(19.2, 78, 20.2, 82)}, 3).why_not, Refusal::kTooTight);
}

// (a) The extent across has to be below the threshold, not equal to it.
TEST(VersleijenDetour, IsRefusedFromTheThresholdOn) {
  const std::vector<Ring> two_wide{rectangle(18.5, 79, 20.5, 81)};
  EXPECT_EQ(way_in_field(3, 1, two_wide, 2).why_not, Refusal::kTooWide);
  EXPECT_EQ(way_in_field(3, 1, two_wide, 1).why_not, Refusal::kTooWide);
  EXPECT_TRUE(way_in_field(3, 1, two_wide, 2.001).possible());
}

TEST(VersleijenDetour, IsRefusedRoundAShapeThatIsNotConvex) {
  const Ring arrow{{19, 78}, {19.5, 79}, {20, 78}, {19.5, 82}};
  EXPECT_EQ(way_in_field(3, 1, {arrow}, 3).why_not, Refusal::kKinkedBuffer);
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
  EXPECT_TRUE(versleijen_detour(obstruction, 3, with(rectangle(25, 79, 26, 81))).possible());
  const WayRound two = versleijen_detour(obstruction, 3, with(rectangle(18.2, 79.8, 18.3, 80.2)));
  EXPECT_EQ(two.why_not, Refusal::kSeveralObstacles);
  EXPECT_EQ(two.hazards, (std::vector<std::size_t>{0, 1}));
  around.hazards.clear();
  EXPECT_FALSE(versleijen_detour(obstruction, 3, around).possible());
}

// With r = 12 m the path is 11.9 m off beside the first pole: there stands the second.
TEST(VersleijenDetour, IsRefusedWhereItMeetsAnotherObstacle) {
  const Ring first = regular(16, 1, {19.4, 80});
  EXPECT_EQ(way_in_field(3, 12, {first, regular(16, 0.5, {31.4, 80})}, 3).why_not, Refusal::kMeetsObstacle);
  EXPECT_TRUE(way_in_field(3, 12, {first, regular(16, 0.5, {34, 80})}, 3).possible());
}

// The field begins at y = 0. Ends lie √(24² − 12.1²) = 20.73 m before the obstacle's centre.
TEST(VersleijenDetour, IsRefusedWhereTheTrackEndsBefore) {
  EXPECT_EQ(way_in_field(3, 12, {regular(16, 1, {19.4, 20.6})}, 3).why_not, Refusal::kVersleijenEndsBefore);
  EXPECT_TRUE(way_in_field(3, 12, {regular(16, 1, {19.4, 20.9})}, 3).possible());
}

// The path is 12 − 0.6 m off where it is farthest, the centre line of the fourth strip 10.5 m from the edge.
TEST(VersleijenDetour, IsRefusedWhereItLeavesTheField) {
  const WayRound out = way_in_strip(3, 3, 12, {regular(16, 1, {11.1, 80})}, 3);
  EXPECT_EQ(out.detour.side, Passing::kLeft) << "the side with the smaller displacement, whatever lies there";
  EXPECT_EQ(out.why_not, Refusal::kLeavesField);
  EXPECT_TRUE(way_in_strip(3, 3, 12, {regular(16, 1, {9.9, 80})}, 3).possible()) << "to the right";
}

// Passable land 2.5 m beside the track would be worked on the way.
TEST(VersleijenDetour, IsRefusedWhereItEntersPassableLand) {
  const Ring ditch = rectangle(22, 70, 22.5, 90);
  EXPECT_EQ(way_in_field(3, 6, {regular(16, 1, {19.2, 80})}, 3, {ditch}).why_not, Refusal::kEntersPassable);
  EXPECT_TRUE(way_in_field(3, 6, {regular(16, 1, {19.8, 80})}, 3, {ditch}).possible()) << "on the other side";
}

}  // namespace
}  // namespace tramline
