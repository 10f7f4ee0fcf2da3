// Which lines a terminal gets of a plan: checked against the geometry of the plan itself.

#include "tramline/io/terminal/terminal_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/export/export_fixture.h"
#include "support/refusals.h"
#include "support/small_plan.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/path/path.h"

namespace tramline::io {
namespace {

double farthest_from(const std::vector<Point>& line, const std::vector<Point>& points) {
  double out = 0;
  for (const Point p : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(p, line[i], line[i + 1]));
    out = std::max(out, nearest);
  }
  return out;
}

TEST(TerminalField, TheLineOfASubfieldLiesOnItsLongestTrackAndReachesItsEnds) {
  Plan plan = sample_plan();
  plan.pieces.resize(2);  // 3,000 m and 400 m, straight but for a detour
  const std::vector<TerminalLine> lines = lines_of(plan, LineChoice::kSubfields, 0.02);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].name, "AB 1");
  EXPECT_TRUE(lines[0].parallels);
  ASSERT_TRUE(lines[0].straight());
  const TrackPiece& longest = plan.pieces[0];
  EXPECT_LT(farthest_from(lines[0].points, {longest.start, longest.end}), 1e-9);
  // The subfield reaches from x = -1600 to x = 1600; the track is almost along x, and its corners up to 500 m
  // beside it.
  EXPECT_NEAR(lines[0].points[0].x, -1600, 0.2);
  EXPECT_NEAR(lines[0].points[1].x, 1600, 0.2);
}

TEST(TerminalField, ASubfieldWithCurvedTracksGetsACurveWithoutDetours) {
  Plan plan = sample_plan();
  plan.pieces = {plan.pieces[2]};
  for (const double tolerance_m : {0.0, 0.02, 0.5}) {
    const std::vector<TerminalLine> lines = lines_of(plan, LineChoice::kSubfields, tolerance_m);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].name, "Curve 1");
    EXPECT_FALSE(lines[0].straight());
    EXPECT_EQ(lines[0].points.front(), (Point{-100, 40}));
    EXPECT_EQ(lines[0].points.back(), (Point{-60, 50}));
    EXPECT_LE(farthest_from(lines[0].points, chords(plan.pieces[0].curve)), tolerance_m + 2 * kChordSagitta);
  }
}

TEST(TerminalField, AllLinesAreTheTracksInDrivingOrderAndTheHeadlandPasses) {
  const Plan plan = sample_plan();
  const std::vector<TerminalLine> lines = lines_of(plan, LineChoice::kAll, 0.02);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].name, "Track 1");
  EXPECT_TRUE(lines[0].straight());
  EXPECT_EQ(lines[0].points.front(), plan.pieces[0].start);
  EXPECT_EQ(lines[0].points.back(), plan.pieces[0].end);
  EXPECT_FALSE(lines[1].straight()) << "it has a detour";
  EXPECT_EQ(lines[3].name, "Headland 1");
  EXPECT_EQ(lines[3].points.front(), lines[3].points.back()) << "the pass is closed";
  for (const TerminalLine& line : lines) EXPECT_FALSE(line.parallels);
  const auto driven = [&](std::size_t i) {
    return chords(i < 3 ? centre_line(plan.pieces[i]) : plan.headland.passes[0].path);
  };
  for (std::size_t i = 0; i < lines.size(); ++i)
    EXPECT_LE(farthest_from(lines[i].points, driven(i)), 0.02 + 1e-9) << lines[i].name;
}

TEST(TerminalField, ASubfieldWithoutTracksHasNoLine) {
  Plan plan = testing_support::small_plan();
  plan.subfields.push_back(plan.subfields.front());
  EXPECT_EQ(lines_of(plan, LineChoice::kSubfields, 0.02).size(), 1U);
  plan.pieces.clear();
  EXPECT_TRUE(lines_of(plan, LineChoice::kSubfields, 0.02).empty());
}

// A field in two parts, the second with a pond, and a gap in each.
TEST(TerminalField, EachPartOfAnEvaluatedFieldIsAField) {
  Coverage coverage;
  coverage.field_id = "both";
  coverage.frame = {true, 13, 52, 0, 0};
  coverage.field = {
      {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {}},
      {{{200, 0}, {300, 0}, {300, 100}, {200, 100}}, {{{240, 40}, {240, 60}, {260, 60}, {260, 40}}}}};
  coverage.gaps = {{1, {{{210, 10}, {220, 10}, {220, 20}, {210, 20}}, {}}, 100, {215, 15}},
                   {2, {{{10, 10}, {15, 10}, {15, 15}}, {}}, 12.5, {13, 12}}};
  const std::vector<TerminalField> fields = terminal_fields(coverage, 0.02, "coverage.gpkg");
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_TRUE(fields[0].obstacles.empty());
  EXPECT_EQ(fields[1].obstacles.size(), 1U);
  EXPECT_NEAR(fields[1].area_m2, 9600, 1e-9);
  EXPECT_EQ(fields[0].gaps, (std::vector<NumberedGap>{{2, coverage.gaps[1].shape}}));
  EXPECT_EQ(fields[1].gaps, (std::vector<NumberedGap>{{1, coverage.gaps[0].shape}}));
  coverage.field.clear();
  EXPECT_REFUSED(terminal_fields(coverage, 0.02, "coverage.gpkg"));
}

TEST(TerminalField, OfARepairTheGapsAreTold) {
  Plan plan = testing_support::small_plan();
  EXPECT_TRUE(terminal_field(plan, LineChoice::kAll, 0.02, "").gaps.empty());
  plan.kind = PlanKind::kRepair;
  EXPECT_EQ(terminal_field(plan, LineChoice::kAll, 0.02, "").gaps,
            (std::vector<NumberedGap>{{1, plan.body.front()}}));
}

// Along the meridian of 13.02° is true north, a degree and more off the frame's by none but its convergence
// of sin 52° · 0.02°.
TEST(TerminalField, HeadingsAreFromTrueNorth) {
  const LocalFrame frame{true, 13, 52, 0, 0};
  const FrameProjection projection(frame);
  const Point a{13.02, 52}, north{13.02, 52.01}, east{13.0345, 52};
  const auto heading_to = [&](Point b) {
    const TerminalLine line{"AB 1", true, {*projection.from_lonlat(a), *projection.from_lonlat(b)}};
    return true_heading_deg(line, frame, a);
  };
  EXPECT_NEAR(std::remainder(heading_to(north), 360), 0, 1e-3);
  EXPECT_NEAR(heading_to(east), 90, 0.01) << "parallels are no straight lines: half of sin 52° · 0.0145°";
}

TEST(TerminalField, PlainMetresHaveNoPlaceOnTheGlobe) {
  Plan plan = testing_support::small_plan();
  plan.field.frame = {};
  const std::string refusal =
      testing_support::refusal_of([&] { terminal_field(plan, LineChoice::kSubfields, 0.02, "plan.gpkg"); });
  EXPECT_TRUE(testing_support::mentions(refusal, "plan.gpkg")) << refusal;
  EXPECT_TRUE(testing_support::mentions(refusal, "'small'")) << refusal;
}

}  // namespace
}  // namespace tramline::io
