#include "tramline/coverage/drive/step_maker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coverage/logs.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;

std::vector<WorkedStep> steps_of(const std::vector<Fix>& fixes, const DriveSettings& settings,
                                 const std::vector<Boom>& booms) {
  StepMaker maker(settings);
  std::vector<WorkedStep> out;
  for (const Fix& f : fixes)
    if (const std::optional<WorkedStep> step = maker.add(f, booms)) out.push_back(*step);
  return out;
}

std::vector<WorkedStep> steps_of(const std::vector<Fix>& fixes, const DriveSettings& settings = {}) {
  return steps_of(fixes, settings, {boom(1, 4)});
}

double area_of(const Quad& quad) { return std::abs(signed_area(Ring(quad.begin(), quad.end()))); }

double quads_m2(const std::vector<WorkedStep>& steps) {
  double sum = 0;
  for (const WorkedStep& step : steps)
    for (const Quad& quad : step.quads) sum += area_of(quad);
  return sum;
}

void expect_near(Point found, Point wanted) {
  EXPECT_NEAR(found.x, wanted.x, 1e-9);
  EXPECT_NEAR(found.y, wanted.y, 1e-9);
}

void expect_quad(const Quad& found, const Quad& wanted) {
  for (std::size_t i = 0; i < 4; ++i) expect_near(found[i], wanted[i]);
}

// Driving east, the left side is north.
TEST(StepMaker, LeftIsLeftWhateverTheHeading) {
  const std::vector<WorkedStep> east = steps_of({fix(0, {0, 0}, 90), fix(1, {2, 0}, 90)});
  ASSERT_EQ(east.size(), 1U);
  expect_quad(east[0].quads.at(0), {{{0, 2}, {0, -2}, {2, -2}, {2, 2}}});
  // Zhang eqs. 3 and 4 change sides where the heading enters the lower half circle.
  const std::vector<WorkedStep> west = steps_of({fix(0, {0, 0}, 270), fix(1, {-2, 0}, 270)});
  expect_quad(west[0].quads.at(0), {{{0, -2}, {0, 2}, {-2, 2}, {-2, -2}}});
  const std::vector<WorkedStep> south = steps_of({fix(0, {0, 0}, 180), fix(1, {0, -2}, 180)});
  expect_quad(south[0].quads.at(0), {{{2, 0}, {-2, 0}, {-2, -2}, {2, -2}}});
}

TEST(StepMaker, WithoutAHeadingTheCourseIsTaken) {
  const std::vector<WorkedStep> steps = steps_of({fix(0, {0, 0}), fix(1, {2, 0}), fix(2, {2, 2})});
  ASSERT_EQ(steps.size(), 2U);
  expect_quad(steps[0].quads.at(0), {{{0, 2}, {0, -2}, {2, -2}, {2, 2}}});
  // From the bar across the first course to the one across the second.
  expect_quad(steps[1].quads.at(0), {{{2, 2}, {2, -2}, {4, 2}, {0, 2}}});
}

TEST(StepMaker, AMachineThatReversesKeepsItsHeading) {
  const std::vector<WorkedStep> steps = steps_of({fix(0, {0, 0}), fix(1, {2, 0}), fix(2, {1, 0})});
  ASSERT_EQ(steps.size(), 2U);
  expect_quad(steps[1].quads.at(0), {{{2, 2}, {2, -2}, {1, -2}, {1, 2}}});
}

TEST(StepMaker, ARectangleAlongTheStepOnRequest) {
  DriveSettings settings;
  settings.quads = QuadShape::kSegment;
  const std::vector<WorkedStep> steps = steps_of({fix(0, {0, 0}, 80), fix(1, {2, 0}, 100)}, settings);
  ASSERT_EQ(steps.size(), 1U);
  expect_quad(steps[0].quads.at(0), {{{0, 2}, {0, -2}, {2, -2}, {2, 2}}});
}

// Backwards along a segment the left side of the machine stays on its side.
TEST(StepMaker, ASegmentDrivenBackwardsIsWorkedOnTheSameSide) {
  DriveSettings settings;
  settings.quads = QuadShape::kSegment;
  const std::vector<Boom> left_half = {{{2, 0}}};
  const std::vector<WorkedStep> steps =
      steps_of({fix(0, {0, 0}, 90), fix(1, {-2, 0}, 90)}, settings, left_half);
  ASSERT_EQ(steps.size(), 1U);
  expect_quad(steps[0].quads.at(0), {{{0, 2}, {0, 0}, {-2, 0}, {-2, 2}}});
}

TEST(StepMaker, WorkSwitchesHalfWayOrAtTheSecondFix) {
  const std::vector<Fix> fixes = {idle(fix(0, {0, 0}, 90)), fix(1, {2, 0}, 90), fix(2, {4, 0}, 90),
                                  idle(fix(3, {6, 0}, 90)), idle(fix(4, {8, 0}, 90))};
  const std::vector<WorkedStep> half_way = steps_of(fixes);
  ASSERT_EQ(half_way.size(), 3U);
  expect_quad(half_way[0].quads.at(0), {{{1, 2}, {1, -2}, {2, -2}, {2, 2}}});
  expect_quad(half_way[2].quads.at(0), {{{4, 2}, {4, -2}, {5, -2}, {5, 2}}});
  DriveSettings settings;
  settings.switching = Switching::kStep;
  const std::vector<WorkedStep> at_fixes = steps_of(fixes, settings);
  ASSERT_EQ(at_fixes.size(), 2U);
  expect_quad(at_fixes[0].quads.at(0), {{{2, 2}, {2, -2}, {4, -2}, {4, 2}}});
  expect_quad(at_fixes[1].quads.at(0), {{{4, 2}, {4, -2}, {6, -2}, {6, 2}}});
}

TEST(StepMaker, WidthChangesHalfWayToo) {
  std::vector<Fix> fixes = {fix(0, {0, 0}, 90), fix(1, {2, 0}, 90)};
  fixes[1].boom = 1;
  const std::vector<Boom> booms = {boom(1, 4), boom(1, 2)};
  const std::vector<WorkedStep> half_way = steps_of(fixes, {}, booms);
  EXPECT_NEAR(quads_m2(half_way), 1 * 4 + 1 * 2, 1e-9);
  DriveSettings settings;
  settings.switching = Switching::kStep;
  EXPECT_NEAR(quads_m2(steps_of(fixes, settings, booms)), 2 * 4, 1e-9);
}

TEST(StepMaker, AdjacentSectionsAreOneQuad) {
  const std::vector<Boom> four = {boom(4, 4)};
  const auto drive = [&](const char* states) {
    return steps_of({with_sections(fix(0, {0, 0}, 90), states), with_sections(fix(1, {2, 0}, 90), states)},
                    {}, four);
  };
  EXPECT_EQ(drive("1111").at(0).quads.size(), 1U);
  const std::vector<WorkedStep> gap = drive("1101");
  ASSERT_EQ(gap.at(0).quads.size(), 2U);
  expect_quad(gap[0].quads[0], {{{0, 2}, {0, 0}, {2, 0}, {2, 2}}});
  expect_quad(gap[0].quads[1], {{{0, -1}, {0, -2}, {2, -2}, {2, -1}}});
  EXPECT_TRUE(drive("0000").empty());
}

TEST(StepMaker, NothingIsWorkedAcrossGapsInTimeOrPlaceNorBackwards) {
  EXPECT_TRUE(steps_of({fix(0, {0, 0}, 90), fix(10.1, {2, 0}, 90)}).empty());
  EXPECT_EQ(steps_of({fix(0, {0, 0}, 90), fix(10, {2, 0}, 90)}).size(), 1U);
  EXPECT_TRUE(steps_of({fix(0, {0, 0}, 90), fix(1, {15.1, 0}, 90)}).empty());
  EXPECT_EQ(steps_of({fix(0, {0, 0}, 90), fix(1, {15, 0}, 90)}).size(), 1U);
  EXPECT_TRUE(steps_of({fix(1, {0, 0}, 90), fix(0, {2, 0}, 90)}).empty());
  EXPECT_EQ(steps_of({fix(std::nan(""), {0, 0}, 90), fix(std::nan(""), {2, 0}, 90)}).size(), 1U);
}

TEST(StepMaker, UnitsAreNotJoined) {
  Fix other = fix(1, {2, 0}, 90);
  other.unit = 1;
  EXPECT_TRUE(steps_of({fix(0, {0, 0}, 90), other}).empty());
}

TEST(StepMaker, ARunEndsWhereTheWorkDoes) {
  const std::vector<WorkedStep> steps =
      steps_of({fix(0, {0, 0}, 90), fix(1, {2, 0}, 90), idle(fix(2, {4, 0}, 90)), fix(3, {6, 0}, 90),
                fix(4, {9, 0}, 90), fix(30, {10, 0}, 90), fix(31, {11, 0}, 90)});
  ASSERT_EQ(steps.size(), 5U);
  EXPECT_EQ(steps[0].run, 0);
  EXPECT_EQ(steps[1].run, 0);
  EXPECT_EQ(steps[2].run, 1);
  EXPECT_EQ(steps[3].run, 1);
  EXPECT_EQ(steps[4].run, 2) << "a gap in time ends it as well";
  EXPECT_DOUBLE_EQ(steps[1].travel_m, 4);
  EXPECT_DOUBLE_EQ(steps[3].travel_m, 5);
  EXPECT_DOUBLE_EQ(steps[4].travel_m, 1);
  EXPECT_DOUBLE_EQ(steps[0].reach_m, 2 + 4) << "the step, and w before it";
}

// The antenna 3 m before the machine's middle and 1 m right of it, the implement 5 m behind: driving north
// from the origin, what works is 8 m south and 1 m west of the antenna.
TEST(StepMaker, TheImplementIsWhereTheMachineCarriesIt) {
  DriveSettings settings;
  settings.antenna_forward_m = 3;
  settings.antenna_right_m = 1;
  settings.implement_behind_m = 5;
  const std::vector<WorkedStep> steps = steps_of({fix(0, {0, 0}, 0), fix(1, {0, 2}, 0)}, settings);
  ASSERT_EQ(steps.size(), 1U);
  expect_quad(steps[0].quads.at(0), {{{-3, -8}, {1, -8}, {1, -6}, {-3, -6}}});
}

// At 50 Hz and 0.5 m/s a step is a centimetre: too short to tell a course by, and yet ground is worked.
TEST(StepMaker, SlowWorkIsNotLost) {
  std::vector<Fix> fixes;
  for (int i = 0; i <= 1000; ++i) fixes.push_back(fix(i / 50.0, {i * 0.01, 0}));
  EXPECT_NEAR(quads_m2(steps_of(fixes)), 10 * 4, 0.1);
  DriveSettings settings;
  settings.quads = QuadShape::kSegment;
  EXPECT_NEAR(quads_m2(steps_of(fixes, settings)), 10 * 4, 0.1);
}

// Standing with the receiver's noise of a centimetre, the course stays what it was.
TEST(StepMaker, AMachineThatStandsDoesNotSpin) {
  std::vector<Fix> fixes;
  for (int i = 0; i <= 20; ++i) fixes.push_back(fix(i, {0.5 * i, 0}));
  for (int i = 0; i < 500; ++i)
    fixes.push_back(fix(21 + i, {10 + 0.01 * std::cos(2.4 * i), 0.01 * std::sin(2.4 * i)}));
  const std::vector<WorkedStep> steps = steps_of(fixes);
  EXPECT_GE(steps.size(), 20U);
  for (const WorkedStep& step : steps)
    for (const Point corner : step.quads.at(0)) {
      EXPECT_LT(corner.x, 10 + 0.02 + 2 * std::sin(0.1));
      EXPECT_LT(std::abs(corner.y), 2.02);
    }
}

TEST(StepMaker, UnknownWorkIsWorkOnlyWhereTheLogNeverSays) {
  Fix unknown = fix(0, {0, 0}, 90);
  unknown.work = WorkState::kUnknown;
  Fix next = unknown;
  next.position = {2, 0};
  next.time_s = 1;
  EXPECT_EQ(steps_of({unknown, next}).size(), 1U);
  DriveSettings settings;
  settings.unknown_work = WorkState::kOff;
  EXPECT_TRUE(steps_of({unknown, next}, settings).empty());
  EXPECT_FALSE(says_work(log({unknown, next}, 4)));
  EXPECT_TRUE(says_work(log({unknown, idle(next)}, 4)));
}

TEST(StepMaker, WithoutAWidthNothingIsWorked) {
  Fix a = fix(0, {0, 0}, 90);
  Fix b = fix(1, {2, 0}, 90);
  a.boom = b.boom = -1;
  StepMaker maker({});
  EXPECT_FALSE(maker.add(a, {}).has_value());
  EXPECT_FALSE(maker.add(b, {}).has_value());
  EXPECT_EQ(maker.breaks().without_width, 2U);
  DriveSettings settings;
  settings.width_m = 3;
  EXPECT_NEAR(quads_m2(steps_of({a, b}, settings, {})), 6, 1e-9);
}

}  // namespace
}  // namespace tramline::coverage
