// From logs and plans to figures, by hand.

#include "tramline/coverage/evaluate.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coverage/logs.h"
#include "tramline/coverage/drive/plan_steps.h"
#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;

/// Two passes of 4 m eastwards and back over a square of 10 m, with the work on between fixes at its edges:
/// the first at y = 2, the second at y = 5, so that a strip of 1 m is worked twice, and one of 3 m is missed.
WorkLog two_passes() {
  return log({idle(fix(0, {-2, 2}, 90)), fix(1, {0, 2}, 90), fix(2, {5, 2}, 90), fix(3, {10, 2}, 90),
              idle(fix(4, {12, 2}, 90)), idle(fix(5, {12, 5}, 270)), fix(6, {10, 5}, 270),
              fix(7, {5, 5}, 270), fix(8, {0, 5}, 270), idle(fix(9, {-2, 5}, 270))},
             4);
}

EvaluateSettings by_steps() {
  EvaluateSettings out;
  out.drive.switching = Switching::kStep;
  return out;
}

TEST(Evaluate, TwoPassesByHand) {
  const Coverage done = evaluate(two_passes(), square(10), by_steps(), {});
  // With --switch step the last step of each pass, 2 m beyond the field, is worked as well.
  EXPECT_NEAR(done.areas.gross_m2, 2 * 12 * 4, 1e-6);
  EXPECT_NEAR(done.areas.covered_inside_m2, 10 * 7, 1e-6);
  EXPECT_NEAR(done.areas.outside_m2, 2 * 4 + 2 * 4, 1e-6);
  EXPECT_NEAR(done.areas.repeated_m2, 10 * 1, 1e-6);
  EXPECT_NEAR(done.areas.sliver_m2, 0, 1e-6);
  EXPECT_NEAR(done.areas.missed_m2, 10 * 3, 1e-6);
  EXPECT_NEAR(done.areas.worked_times_m2[1], 70 + 16 - 10, 1e-6);
  EXPECT_NEAR(done.areas.worked_times_m2[2], 10, 1e-6);
  EXPECT_EQ(done.runs, 2);
  EXPECT_EQ(done.fixes_used, 10U);
  EXPECT_DOUBLE_EQ(done.worked_s, 6);
  ASSERT_EQ(done.gaps.size(), 1U);
  EXPECT_NEAR(done.gaps[0].area_m2, 30, 1e-6);
  EXPECT_NEAR(done.gaps[0].widest_m, 3, 0.02);
  EXPECT_DOUBLE_EQ(done.width_m, 4);
}

/// A step eastwards of 4 m width along y = 8.5 over the whole square.
WorkedStep step_over_the_rest() {
  return {{{Point{0, 10.5}, Point{0, 6.5}, Point{10, 6.5}, Point{10, 10.5}}}, 0, 10, 14, 0};
}

// The two passes leave y from 7 to 10; the work that follows covers that, half a metre of worked ground again
// and half a metre beyond the field.
TEST(Evaluate, WorkThatFollowsTheLogIsAddedToIt) {
  const FurtherWork repair{{step_over_the_rest()}, {{{0, 8.5}, {10, 8.5}}}};
  const Coverage before = evaluate(two_passes(), square(10), by_steps(), {});
  const Coverage done = evaluate(two_passes(), square(10), by_steps(), {}, {}, repair);
  EXPECT_NEAR(done.areas.missed_m2, 0, 1e-6);
  EXPECT_NEAR(done.areas.covered_inside_m2, 100, 1e-6);
  EXPECT_NEAR(done.areas.outside_m2 - before.areas.outside_m2, 5, 1e-6);
  EXPECT_NEAR(done.areas.repeated_m2 - before.areas.repeated_m2, 5, 1e-6);
  EXPECT_NEAR(done.areas.gross_m2 - before.areas.gross_m2, 40, 1e-6);
  EXPECT_TRUE(done.gaps.empty());
  EXPECT_EQ(done.runs, before.runs + 1);
  EXPECT_EQ(done.fixes_used, before.fixes_used);
  ASSERT_EQ(done.lines.size(), before.lines.size() + 1);
  EXPECT_EQ(done.lines.back().run, before.runs);
}

TEST(Evaluate, BySwitchingHalfWayOneMetreEitherEndIsWorked) {
  const Coverage done = evaluate(two_passes(), square(10), {}, {});
  EXPECT_NEAR(done.areas.gross_m2, 2 * 12 * 4, 1e-6);
  EXPECT_NEAR(done.areas.outside_m2, 4 * 4 - 2 * 1, 1e-6) << "the strip of 1 m worked twice at either end";
}

TEST(Evaluate, SlicesSumUpToTheWhole) {
  EvaluateSettings settings = by_steps();
  settings.slice = 4;
  const Coverage done = evaluate(two_passes(), square(10), settings, {});
  ASSERT_EQ(done.slices.size(), 3U);
  EXPECT_EQ(done.slices[0].fixes, 4U);
  EXPECT_NEAR(done.slices[0].areas.covered_m2, 10 * 4, 1e-6);
  EXPECT_NEAR(done.slices[0].areas.missed_m2, 100 - 40, 1e-6);
  EXPECT_EQ(done.slices[2].fixes, 10U);
  EXPECT_NEAR(done.slices[2].areas.covered_m2, done.areas.covered_m2, 1e-9);
  EXPECT_EQ(done.slices[2].missed_regions, 1U);
}

TEST(Evaluate, MoreSlicesThanAreMadeAreRefusedWithTheNumberThatGoes) {
  std::vector<Fix> fixes;
  for (int i = 0; i < 2002; ++i) fixes.push_back(fix(i, {0.01 * i, 0}));
  const WorkLog long_log = log(std::move(fixes), 4);
  EvaluateSettings settings = by_steps();
  settings.slice = 2;
  const Error refused = testing_support::error_of([&] { evaluate(long_log, {}, settings, {}); });
  EXPECT_EQ(refused.kind(), ErrorKind::kBadInput);
  const std::string sentence = refused.what();
  EXPECT_NE(sentence.find("2002 fixes"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("1001 slices, and the most are 1000; give --slice 3 or more"), std::string::npos)
      << sentence;
  settings.slice = 3;
  EXPECT_EQ(evaluate(long_log, {}, settings, {}).slices.size(), 668U);
}

// A right-angled bend of rectangles 4 m wide: the kite on its inside is (w/2)²·tan(45°) = 4 m² and lies
// within the last w of travel: a sliver, and repeated only for the strict.
TEST(Evaluate, TheInsideOfABendIsASliver) {
  const WorkLog bend = log({fix(0, {0, 0}), fix(1, {10, 0}), fix(2, {10, 10})}, 4);
  EvaluateSettings settings;
  settings.drive.quads = QuadShape::kSegment;
  const Coverage done = evaluate(bend, {}, settings, {});
  EXPECT_NEAR(done.areas.sliver_m2, 4, 1e-6);
  EXPECT_NEAR(done.areas.repeated_m2, 0, 1e-6);
  settings.repeat = RepeatRule::kStrict;
  const Coverage strict = evaluate(bend, {}, settings, {});
  EXPECT_NEAR(strict.areas.repeated_m2, 4, 1e-6);
  EXPECT_NEAR(area(strict.repeated), 4, 1e-6);
}

/// 10 m to the east, 1 m to the north and 10 m back, as rectangles 4 m wide:
///   A = [0, 10] x [-2, 2], B = [8, 12] x [0, 1], C = [0, 10] x [-1, 3].
/// A and B share [8, 10] x [0, 1], 2 m2; A and C share [0, 10] x [-1, 2], 30 m2, and so does B with C what it
/// shares with A. All is within one run and the last w of its travel: A ends at 10 m, C at 21 m, and its own
/// trail reaches back 10 + 4 m.
WorkLog u_turn() { return log({fix(0, {0, 0}), fix(1, {10, 0}), fix(2, {10, 1}), fix(3, {0, 1})}, 4); }

// Where three steps overlap, at [8, 10] x [0, 1], what each shares with the land before adds up to
// 2 + 30 m2, while 30 m2 of land were worked again: land counts once, however often it was worked.
TEST(Evaluate, LandWorkedThreeTimesAsASliverCountsOnce) {
  for (const EngineKind engine : {EngineKind::kExact, EngineKind::kMesh}) {
    SCOPED_TRACE(name(engine));
    EvaluateSettings settings;
    settings.engine = engine;
    settings.mesh_m = 0.25;  // all edges lie on its grid
    settings.drive.quads = QuadShape::kSegment;
    const Coverage run = evaluate(u_turn(), {}, settings, {});
    settings.repeat = RepeatRule::kStrict;
    settings.slice = 2;
    const Coverage strict = evaluate(u_turn(), {}, settings, {});
    EXPECT_NEAR(strict.areas.gross_m2, 40 + 4 + 40, 1e-6);
    EXPECT_NEAR(strict.areas.covered_m2, 50 + 2, 1e-6);  // A and C together, and [10, 12] x [0, 1]
    EXPECT_NEAR(strict.areas.gross_m2 - strict.areas.covered_m2, 2 + 30, 1e-6);
    EXPECT_NEAR(strict.areas.repeated_m2, 30, 1e-6);
    EXPECT_EQ(strict.areas.sliver_m2, 0) << "they are in the repeated land already";
    EXPECT_NEAR(strict.areas.worked_twice_m2(), 30, 1e-6);
    EXPECT_NEAR(area(strict.repeated), 30, 1e-6);
    ASSERT_EQ(strict.slices.size(), 2U);
    EXPECT_NEAR(strict.slices[1].areas.worked_twice_m2(), 30, 1e-6);
    EXPECT_NEAR(run.areas.worked_twice_m2(), 30, 1e-6);
    if (engine == EngineKind::kMesh) continue;
    EXPECT_NEAR(run.areas.repeated_m2, 0, 1e-6);
    EXPECT_NEAR(run.areas.sliver_m2, 30, 1e-6);
    EXPECT_NEAR(strict.areas.worked_times_m2[2], 28, 1e-6);
    EXPECT_NEAR(strict.areas.worked_times_m2[3], 2, 1e-6);
  }
}

TEST(Evaluate, TheOrderOfRecordsDoesNotMatter) {
  WorkLog mixed = two_passes();
  std::swap(mixed.fixes[2], mixed.fixes[7]);
  const Coverage done = evaluate(mixed, square(10), by_steps(), {});
  EXPECT_NEAR(done.areas.covered_inside_m2, 70, 1e-6);
  EXPECT_EQ(done.warnings.size(), 1U);
}

TEST(Evaluate, WhatCannotBeEvaluatedIsRefused) {
  EXPECT_REFUSED(evaluate(log({}, 4), {}, {}, {}));
  EXPECT_REFUSED(evaluate(log({fix(0, {0, 0})}, 4), {}, {}, {}));
  WorkLog nameless = two_passes();
  for (Fix& f : nameless.fixes) f.boom = -1;
  EXPECT_REFUSED(evaluate(nameless, {}, {}, {}));
}

TEST(Evaluate, BothEnginesSeeTheSameDrive) {
  EvaluateSettings settings = by_steps();
  settings.engine = EngineKind::kMesh;
  const Coverage done = evaluate(two_passes(), square(10), settings, {});
  EXPECT_EQ(done.engine, "mesh");
  EXPECT_NEAR(done.areas.covered_inside_m2, 70, 0.007 * 70);
  EXPECT_NEAR(done.areas.repeated_m2, 10, 0.007 * 10);
  EXPECT_NEAR(done.areas.missed_m2, 30, 0.5);
  EXPECT_NEAR(area(done.worked_times[1]), done.areas.worked_times_m2[1], 0.007 * 76);
  EXPECT_TRUE(done.worked_times[2].empty()) << "meshes do not count further";
}

TEST(Evaluate, ShapesAndThreadsChangeNoFigure) {
  const Coverage whole = evaluate(two_passes(), square(10), by_steps(), {});
  EXPECT_NEAR(area(whole.covered), 86, 1e-6);
  EXPECT_NEAR(area(whole.worked_times[1]), 76, 1e-6);
  EvaluateSettings figures = by_steps();
  figures.shapes = false;
  figures.threads = 1;
  const Coverage alone = evaluate(two_passes(), square(10), figures, {});
  EXPECT_TRUE(alone.covered.empty());
  EXPECT_EQ(alone.areas.covered_m2, whole.areas.covered_m2);
  EXPECT_EQ(alone.missed, whole.missed);
  ASSERT_EQ(alone.gaps.size(), 1U);
}

// A plan of two tracks over the square whose swaths overlap by 1 m and end 1 m beyond it: o = 10 + 2·(4 + 4)
// − 2·1 … counted as gross − covered inside; u = the strip of 3 m.
TEST(Evaluate, ThePlansDriveHasThePlansTally) {
  Plan plan;
  plan.machine.width_m = 4;
  plan.pieces = {{{-1, 2}, {11, 2}}, {{11, 5}, {-1, 5}}};
  const Coverage done = evaluate(plan_steps(plan), 4, square(10), {});
  EXPECT_NEAR(done.areas.missed_m2, 30, 1e-6);
  EXPECT_NEAR(done.areas.gross_m2 - done.areas.covered_inside_m2, 2 * 12 * 4 - 70, 1e-6);
}

}  // namespace
}  // namespace tramline::coverage
