// What surrounds the steps: courses, order of time, lines, gaps.

#include <gtest/gtest.h>

#include <cmath>

#include "coverage/logs.h"
#include "tramline/coverage/drive/course.h"
#include "tramline/coverage/drive/driven_lines.h"
#include "tramline/coverage/drive/log_sanity.h"
#include "tramline/coverage/drive/time_order.h"
#include "tramline/coverage/drive/working_boom.h"
#include "tramline/coverage/gaps.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;

TEST(Course, FollowsACircleDrivenFastOrSlowly) {
  for (const double step_m : {0.03, 0.2, 1.0}) {
    Course course;
    const double radius_m = 6;
    for (int i = 0; i < 400; ++i) {
      const double angle = i * step_m / radius_m;  // anticlockwise from east; heading north at first
      const std::optional<Heading> heading =
          course.at({radius_m * std::cos(angle), radius_m * std::sin(angle)});
      if (i * step_m < 2 * kCourseBase_m) continue;
      ASSERT_TRUE(heading.has_value());
      // A chord points half its turn back: half of 0.25 m, or of the step, over 6 m.
      const double behind = (std::max(step_m, kCourseBase_m + step_m)) / 2 / radius_m;
      const Heading tangent = Heading::clockwise_from_north(Angle::radians(-angle));
      EXPECT_GT(dot(heading->unit(), tangent.unit()), std::cos(behind + 1e-9)) << step_m << " m, place " << i;
    }
  }
}

TEST(Course, IsUnknownBeforeTheFirstStep) {
  Course course;
  EXPECT_FALSE(course.at({0, 0}).has_value());
  EXPECT_FALSE(course.at({0.01, 0}).has_value());
  EXPECT_TRUE(course.at({0.3, 0}).has_value());
}

TEST(WorkingBoom, StatesOfSectionsTheBoomDoesNotHaveAreIgnored) {
  const Fix f = with_sections(fix(0, {}), "0111");
  const Boom working = working_boom(f, boom(2, 4), WorkState::kOn);
  ASSERT_EQ(working.size(), 1U);
  EXPECT_EQ(working[0], (Section{0, -2}));
  EXPECT_TRUE(working_boom(idle(f), boom(2, 4), WorkState::kOn).empty());
}

TEST(TimeOrder, PutsFixesInOrderAndCountsThem) {
  Fix nameless = fix(std::nan(""), {9, 9});
  const WorkLog mixed = log({fix(0, {0, 0}), fix(2, {2, 0}), nameless, fix(1, {1, 0}), fix(3, {3, 0})}, 4);
  EXPECT_EQ(out_of_order(mixed), 1U);
  const WorkLog sorted = in_time_order(mixed);
  EXPECT_EQ(out_of_order(sorted), 0U);
  const std::vector<double> x = {0, 1, 2, 9, 3};
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(sorted.fixes[i].position.x, x[i]);
}

TEST(DrivenLines, ChangeWhereTheWorkDoes) {
  DrivenLines lines;
  WorkedStep working;
  working.run = 0;
  lines.add(fix(0, {}), {0, 0}, Continuity::kBroken, std::nullopt);
  lines.add(fix(1, {}), {1, 0}, Continuity::kJoined, working);
  lines.add(fix(2, {}), {2, 0}, Continuity::kJoined, working);
  lines.add(fix(3, {}), {3, 0}, Continuity::kJoined, std::nullopt);
  lines.add(fix(9, {}), {9, 0}, Continuity::kBroken, std::nullopt);
  const std::vector<DrivenLine> out = lines.lines();
  ASSERT_EQ(out.size(), 2U) << "a single place is no line";
  EXPECT_EQ(out[0].run, 0);
  EXPECT_EQ(out[0].line, (std::vector<Point>{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(out[0].to_s, 2);
  EXPECT_EQ(out[1].run, -1);
  EXPECT_EQ(out[1].line, (std::vector<Point>{{2, 0}, {3, 0}}));
}

TEST(Plausible, CopiesOfOneWidthAreOne) {
  WorkLog copies = log({fix(0, {0, 0}), with_sections(fix(1, {1, 0}), "0000000001")}, 10);
  copies.booms = {boom(10, 100)};
  const WorkLog mended = log_without_faults(copies);
  EXPECT_EQ(mended.booms[0], boom(1, 10));
  EXPECT_TRUE(mended.fixes[1].sections[0]);
  EXPECT_EQ(mended.notes.size(), 1U);
  copies.booms = {boom(48, 48)};
  EXPECT_EQ(log_without_faults(copies).booms[0].size(), 48U) << "a wide sprayer is no fault";
}

TEST(Plausible, SectionsThatNeverWorkSayNothing) {
  const Fix silent = with_sections(fix(0, {0, 0}), "0000");
  EXPECT_FALSE(log_without_faults(log({silent}, 4)).fixes[0].has_sections);
  EXPECT_TRUE(
      log_without_faults(log({silent, with_sections(fix(1, {1, 0}), "1000")}, 4)).fixes[0].has_sections);
  EXPECT_TRUE(log_without_faults(log({idle(silent)}, 4)).fixes[0].has_sections) << "nothing contradicts them";
}

TEST(Gaps, AreListedTheLargestFirst) {
  const Polygon small{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {}};
  const Polygon large{{{10, 0}, {13, 0}, {13, 4}, {10, 4}}, {}};
  const Polygon sliver{{{20, 0}, {20.09, 0}, {20.09, 0.1}, {20, 0.1}}, {}};
  const std::vector<Gap> gaps = gaps_of({small, large, sliver});
  ASSERT_EQ(gaps.size(), 2U) << "0.009 m² are no gap";
  EXPECT_EQ(gaps[0].number, 1);
  EXPECT_DOUBLE_EQ(gaps[0].area_m2, 12);
  EXPECT_NEAR(gaps[0].widest_m, 3, 2 * kGapWidth_m);
  EXPECT_NEAR(gaps[0].centre.x, 11.5, kGapWidth_m);
  EXPECT_NEAR(gaps[1].widest_m, 1, 2 * kGapWidth_m);
}

}  // namespace
}  // namespace tramline::coverage
