// Ground between fixes that the log lacks: what may have been worked and was not recorded, by hand.

#include "tramline/coverage/drive/log_hole.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coverage/logs.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/coverage/tiles/tile_coverage.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;

/// 60 m by 10 m.
Region strip_of_land() { return {{{{0, 0}, {60, 0}, {60, 10}, {0, 10}}, {}}}; }

/// Eastwards along y = 5 at 2 m/s, one fix a second: from x = 0 to 30, then from `again_m` after so many
/// seconds to x = 60. Heading 90 where `headings` says so.
WorkLog with_hole(double again_m, double seconds, bool headings = true, double heading_after_deg = 90) {
  std::vector<Fix> fixes;
  for (int i = 0; i <= 15; ++i) fixes.push_back(headings ? fix(i, {2.0 * i, 5}, 90) : fix(i, {2.0 * i, 5}));
  for (double x = again_m; x <= 60; x += 2) {
    const double time_s = 15 + seconds + (x - again_m) / 2;
    fixes.push_back(headings ? fix(time_s, {x, 5}, heading_after_deg) : fix(time_s, {x, 5}));
  }
  return log(std::move(fixes), 4);
}

void expect_whole(const Coverage& done) {
  EXPECT_NEAR(done.areas.covered_inside_m2 + done.areas.missed_m2 + done.areas.not_recorded_m2,
              area(done.field.empty() ? strip_of_land() : done.field), 1e-6);
  EXPECT_NEAR(area(done.missed), done.areas.missed_m2, 1e-3);
  EXPECT_NEAR(area(done.not_recorded), done.areas.not_recorded_m2, 1e-3);
  EXPECT_NEAR(done.areas.worked_times_m2[0], done.areas.missed_m2 + done.areas.not_recorded_m2, 1e-6);
}

// 20 m lost in 11 s: 20 · 4 m² are not recorded, 40 · 4 m² covered, and the rest of the field is missed.
TEST(LogHole, TheStraightStripIsNotRecordedAndNotMissed) {
  for (const bool headings : {true, false}) {
    const Coverage done = evaluate(with_hole(50, 11, headings), strip_of_land(), {}, {});
    EXPECT_NEAR(done.areas.not_recorded_m2, 80, 1e-6);
    EXPECT_NEAR(done.areas.covered_inside_m2, 160, 1e-6);
    EXPECT_NEAR(done.areas.missed_m2, 600 - 240, 1e-6);
    expect_whole(done);
    for (const Gap& gap : done.gaps) EXPECT_FALSE(contains(gap.shape, {40, 5}));
  }
}

// 16 m in 8 s is no gap in time, but too far to be joined.
TEST(LogHole, AJumpIsAHoleToo) {
  EXPECT_NEAR(evaluate(with_hole(46, 8), strip_of_land(), {}, {}).areas.not_recorded_m2, 64, 1e-6);
}

TEST(LogHole, WithoutAFieldTheStripCountsWhereverItLies) {
  const Coverage done = evaluate(with_hole(50, 11), {}, {}, {});
  EXPECT_NEAR(done.areas.not_recorded_m2, 80, 1e-6);
  EXPECT_EQ(done.areas.missed_m2, 0);
}

// In half an hour at 2 m/s a machine drives 3600 m: it did something else besides, but it went straight on.
TEST(LogHole, AMachineThatStoodMeanwhileWentStraightOnAllTheSame) {
  EXPECT_NEAR(evaluate(with_hole(50, 1800), strip_of_land(), {}, {}).areas.not_recorded_m2, 80, 1e-6);
}

// Twice its usual 2 m/s is the most that is believed.
TEST(LogHole, FasterThanTheMachineDrivesIsNotBelieved) {
  EXPECT_EQ(evaluate(with_hole(50, 4.5), strip_of_land(), {}, {}).areas.not_recorded_m2, 0);
  EXPECT_GT(evaluate(with_hole(50, 5.5), strip_of_land(), {}, {}).areas.not_recorded_m2, 79);
}

// Behind the hole it drives north: what it did meanwhile is not known, unless there was time for nothing
// else.
TEST(LogHole, WhereItTurnedMeanwhileOnlyTimeDecides) {
  EXPECT_EQ(evaluate(with_hole(50, 60, true, 0), strip_of_land(), {}, {}).areas.not_recorded_m2, 0);
  EXPECT_GT(evaluate(with_hole(50, 11, true, 0), strip_of_land(), {}, {}).areas.not_recorded_m2, 60);
}

TEST(LogHole, NothingIsLostWhereTheWorkWasOffOnEitherSide) {
  WorkLog before = with_hole(50, 11), after = before;
  before.fixes[15] = idle(before.fixes[15]);
  after.fixes[16] = idle(after.fixes[16]);
  EXPECT_EQ(evaluate(before, strip_of_land(), {}, {}).areas.not_recorded_m2, 0);
  EXPECT_EQ(evaluate(after, strip_of_land(), {}, {}).areas.not_recorded_m2, 0);
}

// The left half works before, all of it behind: of the strip the left half counts.
TEST(LogHole, OnlyWhatWorksOnBothSidesCounts) {
  WorkLog half = with_hole(50, 11);
  half.booms = {boom(2, 4)};
  for (std::size_t i = 0; i < half.fixes.size(); ++i)
    half.fixes[i] = with_sections(half.fixes[i], i < 16 ? "10" : "11");
  EXPECT_NEAR(evaluate(half, strip_of_land(), {}, {}).areas.not_recorded_m2, 40, 1e-6);
}

// 5 m of the strip are worked before it is found lost, and 5 m after that.
TEST(LogHole, WorkedGroundIsCoveredWhicheverCameFirst) {
  TileCoverage engine(strip_of_land(), {});
  const auto step = [](double from, double to, int run) {
    return WorkedStep{{{Point{from, 7}, Point{from, 3}, Point{to, 3}, Point{to, 7}}}, run, to - from, 4, 0};
  };
  engine.add(step(30, 35, 0));
  engine.add_unrecorded({{Point{30, 7}, Point{30, 3}, Point{50, 3}, Point{50, 7}}});
  EXPECT_NEAR(engine.areas().not_recorded_m2, 60, 1e-6);
  engine.add(step(45, 50, 1));
  EXPECT_NEAR(engine.areas().not_recorded_m2, 40, 1e-6);
  EXPECT_NEAR(engine.areas().covered_m2, 40, 1e-6);
  EXPECT_NEAR(engine.areas().repeated_m2, 0, 1e-6) << "what was not recorded was not worked";
  EXPECT_NEAR(area(engine.region(LandClass::kUnrecorded)), 40, 1e-4);
  EXPECT_NEAR(area(engine.region(LandClass::kMissed)), 600 - 80, 1e-4);
}

TEST(LogHole, MeshesKnowItToo) {
  EvaluateSettings meshes;
  meshes.engine = EngineKind::kMesh;
  const Coverage done = evaluate(with_hole(50, 11), strip_of_land(), meshes, {});
  EXPECT_NEAR(done.areas.not_recorded_m2, 80, 0.5);
  EXPECT_NEAR(done.areas.missed_m2, 360, 1);
  EXPECT_NEAR(done.areas.covered_inside_m2 + done.areas.missed_m2 + done.areas.not_recorded_m2, 600, 0.5);
}

}  // namespace
}  // namespace tramline::coverage
