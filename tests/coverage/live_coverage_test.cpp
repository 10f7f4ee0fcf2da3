// The evaluation while the drive goes on: what it says against evaluate() on the fixes so far.

#include "tramline/coverage/live/live_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "coverage/logs.h"
#include "coverage/random_log.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/coverage/live/work_changes.h"
#include "tramline/coverage/live/work_rate.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;

WorkLog first(const WorkLog& log, std::size_t fixes) {
  WorkLog out = log;
  out.fixes.resize(fixes);
  return out;
}

WorkLog head_of(WorkLog log) {
  log.fixes.clear();
  log.booms.clear();
  return log;
}

/// All areas, as shares of the covered one.
double difference(const CoverageAreas& a, const CoverageAreas& b) {
  double out = std::max({std::abs(a.gross_m2 - b.gross_m2), std::abs(a.covered_m2 - b.covered_m2),
                         std::abs(a.covered_inside_m2 - b.covered_inside_m2),
                         std::abs(a.outside_m2 - b.outside_m2), std::abs(a.repeated_m2 - b.repeated_m2),
                         std::abs(a.sliver_m2 - b.sliver_m2), std::abs(a.missed_m2 - b.missed_m2)});
  for (std::size_t i = 0; i < a.worked_times_m2.size(); ++i)
    out = std::max(out, std::abs(a.worked_times_m2[i] - b.worked_times_m2[i]));
  return out / std::max(1.0, b.covered_m2);
}

unsigned long long seed() {
  const char* told = std::getenv("TRAMLINE_SEED");
  return told != nullptr ? std::strtoull(told, nullptr, 10) : std::random_device{}();
}

/// A drive, and how it is to be judged: every third round strictly, every fourth by the widths in the log.
struct Round {
  WorkLog log;
  EvaluateSettings settings;
};

void for_random_rounds(int rounds, const std::function<void(const Round&, std::mt19937_64&)>& look) {
  const auto used = seed();
  SCOPED_TRACE("TRAMLINE_SEED=" + std::to_string(used));
  std::mt19937_64 random(used);
  for (int i = 0; i < rounds; ++i) {
    SCOPED_TRACE(i);
    Round round{random_log(random), {}};
    round.settings.repeat = i % 3 == 0 ? RepeatRule::kStrict : RepeatRule::kRun;
    if (i % 4 != 0) round.settings.drive.width_m = 5;
    look(round, random);
  }
}

TEST(LiveCoverage, IsEvaluateAfterEveryFixWhereItSaysSoAndWhereItIsAskedTo) {
  const Region field = square(60);
  std::size_t settled = 0, rebuilt = 0;
  for_random_rounds(60, [&](const Round& round, std::mt19937_64&) {
    const auto& [log, settings] = round;
    LiveCoverage live(field, settings);
    for (std::size_t i = 0; i < log.fixes.size(); ++i) {
      live.add(log.fixes[i], log.booms);
      const bool ask = i % 23 == 22 || i + 1 == log.fixes.size();
      if (i < 1 || (i % 7 != 0 && !ask)) continue;
      settled += live.settled() ? 1 : 0;
      if (ask) live.settle();
      if (!live.settled()) continue;
      const WorkLog so_far = first(log, i + 1);
      Coverage whole;
      try {
        whole = evaluate(so_far, field, settings, {});
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::kBadInput) throw;
        EXPECT_EQ(live.areas().covered_m2, 0) << "no width is known";
        continue;
      }
      EXPECT_LT(difference(live.areas(), whole.areas), 1e-6) << "after " << i + 1 << " fixes";
      const Coverage figures = live.figures(head_of(so_far));
      EXPECT_EQ(figures.runs, whole.runs);
      EXPECT_EQ(figures.warnings, whole.warnings);
      EXPECT_EQ(figures.width_m, whole.width_m);
      EXPECT_NEAR(figures.worked_s, whole.worked_s, 1e-9);
      if (i + 1 < log.fixes.size()) continue;
      const Coverage end = live.coverage(head_of(so_far));
      EXPECT_LT(std::abs(area(end.covered) - area(whole.covered)), 1e-6 * (1 + whole.areas.covered_m2));
      EXPECT_EQ(end.gaps.size(), whole.gaps.size());
      EXPECT_EQ(end.lines.size(), whole.lines.size());
    }
    rebuilt += live.rebuilds();
  });
  EXPECT_GT(settled, 100U) << "the live figures are hardly ever those of evaluate()";
  EXPECT_GT(rebuilt, 20U) << "nothing in these logs changed a judgement";
}

TEST(LiveCoverage, DoubtsGroundThatIsWorkedAgainAndAgain) {
  const Region field = square(60);
  EvaluateSettings settings;
  settings.drive.width_m = 5;
  LiveCoverage live(field, settings);
  WorkLog log;
  log.name = "to and fro";
  log.booms = {boom(1, 5)};
  for (int i = 0; i <= 60; ++i)
    log.fixes.push_back(testing_logs::fix(i, {10.0 + (i / 20 % 2 == 0 ? i % 20 : 20 - i % 20), 30}));
  for (const Fix& fix : log.fixes) live.add(fix, log.booms);
  live.settle();
  const std::vector<std::string> warnings = live.figures(head_of(log)).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings.front().find("of the covered land was worked again"), std::string::npos);
}

/// Somebody who follows a drive by its changes alone.
struct Reader {
  double asks = 1;  ///< after so many of the fixes, 0 … 1
  SeenWork seen{};
  std::map<TileIndex, TileWork> tiles{};
  std::size_t afresh = 0;

  void take(WorkChanges changes) {
    if (changes.all) {
      tiles.clear();
      ++afresh;
    }
    for (TileWork& tile : changes.tiles) tiles.insert_or_assign(tile.index, std::move(tile));
  }
  Region ground(Region TileWork::*of) const {
    Region out;
    for (const auto& [index, tile] : tiles) out.insert(out.end(), (tile.*of).begin(), (tile.*of).end());
    return out;
  }
};

void expect_same_ground(const Region& tiles, const Region& whole, double tolerance_m2) {
  EXPECT_NEAR(area(tiles), area(whole), tolerance_m2);
  EXPECT_NEAR(area(intersection(unite(tiles), whole)), area(whole), tolerance_m2);
}

// However seldom somebody asks, and whatever was worked anew meanwhile: what changed, tile by tile, adds up
// to the whole of it.
TEST(LiveCoverage, WhoFollowsTheChangesHasAllGround) {
  const Region field = square(60);
  std::size_t afresh = 0, compared = 0;
  for_random_rounds(40, [&](const Round& round, std::mt19937_64& random) {
    const auto& [log, settings] = round;
    LiveCoverage live(field, settings);
    std::vector<Reader> readers{{1}, {0.2}, {0.02}};
    for (std::size_t i = 0; i < log.fixes.size(); ++i) {
      live.add(log.fixes[i], log.booms);
      const bool last = i + 1 == log.fixes.size();
      if (last) live.settle();
      for (Reader& reader : readers) {
        if (!last && !std::bernoulli_distribution(reader.asks)(random)) continue;
        reader.take(changes_since(reader.seen, live, settings.repeat));
        const CoverageAreas areas = live.areas();
        const double tolerance_m2 = 1e-6 * std::max(1.0, areas.gross_m2);
        ASSERT_NEAR(area(reader.ground(&TileWork::covered)), areas.covered_m2, tolerance_m2);
        ASSERT_NEAR(area(reader.ground(&TileWork::repeated)), areas.repeated_m2, tolerance_m2);
        ++compared;
        if (!last || live.drive() == nullptr) continue;
        const Engine& engine = live.drive()->engine();
        expect_same_ground(reader.ground(&TileWork::covered), engine.region(LandClass::kCovered), 1e-3);
        expect_same_ground(
            reader.ground(&TileWork::repeated),
            engine.region(settings.repeat == RepeatRule::kStrict ? LandClass::kAgain : LandClass::kRepeated),
            1e-3);
        EXPECT_TRUE(changes_since(reader.seen, live, settings.repeat).tiles.empty());
      }
    }
    afresh += readers.front().afresh - 1;
  });
  EXPECT_GT(afresh, 10U) << "nothing was worked anew";
  EXPECT_GT(compared, 1000U);
}

/// A straight drive with a fix a second, 1 m apart.
WorkLog straight(int fixes) {
  std::vector<Fix> out;
  for (int i = 0; i < fixes; ++i) out.push_back(fix(i, {1.0 * i, 0}, 90));
  return log(std::move(out), 4);
}

TEST(LiveCoverage, AreasAreCurrentAfterEveryFix) {
  const WorkLog drive = straight(50);
  const Region no_field;
  LiveCoverage live(no_field, {});
  for (std::size_t i = 0; i < drive.fixes.size(); ++i) {
    live.add(drive.fixes[i], drive.booms);
    ASSERT_NEAR(live.areas().covered_m2, 4.0 * static_cast<double>(i), 1e-6);
  }
  EXPECT_EQ(live.rebuilds(), 0U);
  // 4 m² a second.
  EXPECT_NEAR(live.present_m2_per_s(), 4, 1e-9);
}

TEST(LiveCoverage, FixesThatAreAllLateCostNineTimesTheirWorkAtMost) {
  WorkLog drive = straight(3000);
  // Each fix with an odd number comes before the one with the even number before it.
  for (std::size_t i = 1; i + 1 < drive.fixes.size(); i += 2) std::swap(drive.fixes[i], drive.fixes[i + 1]);
  const Region no_field;
  LiveCoverage live(no_field, {});
  std::size_t worked_anew = 0, before = 0;
  for (const Fix& one : drive.fixes) {
    live.add(one, drive.booms);
    if (live.rebuilds() != before) worked_anew += live.fixes();
    before = live.rebuilds();
  }
  EXPECT_GT(live.rebuilds(), 10U);
  EXPECT_LE(worked_anew, 9 * drive.fixes.size());
  live.settle();
  EXPECT_NEAR(live.areas().covered_m2, 4.0 * 2999, 1e-3);
}

// The rate is that of the last five minutes of driving: here half of what it was before, and a break of an
// hour does not count.
TEST(LiveCoverage, ThePresentRate) {
  WorkRate rate(10);
  EXPECT_TRUE(std::isnan(rate.m2_per_s()));
  double time_s = 0, done_m2 = 0;
  for (int i = 0; i < 600; ++i) rate.add(time_s += 1, done_m2 += 8);
  EXPECT_NEAR(rate.m2_per_s(), 8, 1e-9);
  time_s += 3600;
  for (int i = 0; i < 310; ++i) rate.add(time_s += 1, done_m2 += 4);
  EXPECT_NEAR(rate.m2_per_s(), 4, 1e-9);
}

/// To the north, a fix a second.
LiveCoverage driven_north(const Region& field, double speed_mps, int fixes, double logged_mps) {
  LiveCoverage out(field, {});
  const std::vector<Boom> booms{boom(2, 3)};
  for (int i = 0; i < fixes; ++i) {
    Fix next = testing_logs::fix(i, {50, 10 + speed_mps * i});
    next.boom = 0;
    next.speed_mps = logged_mps;
    next = with_sections(next, "10");
    out.add(next, booms);
  }
  return out;
}

// 20 m square_field, at y = 16 after four fixes: 4 m to its end at 2 m/s.
TEST(LiveCoverage, LooksAheadFromTheLastFix) {
  const Region field{{{{40, 0}, {60, 0}, {60, 20}, {40, 20}}, {}}};
  for (const double logged_mps : {std::nan(""), 2.0, 4.0}) {
    const LiveCoverage live = driven_north(field, 2, 4, logged_mps);
    const std::optional<Ahead> ahead = live.look_ahead({});
    ASSERT_TRUE(ahead);
    ASSERT_EQ(ahead->sections.size(), 2U);
    EXPECT_TRUE(ahead->sections[0].on);
    EXPECT_FALSE(ahead->sections[1].on);
    ASSERT_TRUE(ahead->sections[0].next);
    EXPECT_FALSE(ahead->sections[0].next->on);
    EXPECT_NEAR(ahead->sections[0].next->ahead_m, 4, 1e-6);
    EXPECT_NEAR(ahead->sections[0].next->effect_s, logged_mps == 4 ? 1 : 2, 1e-6);
    ASSERT_TRUE(ahead->sections[1].next) << "the right section is off over ground that needs work";
    EXPECT_TRUE(ahead->sections[1].next->on);
    EXPECT_NEAR(ahead->sections[1].next->command_s, 0, 1e-3);  // a millimetre ahead
  }
}

TEST(LiveCoverage, DoesNotLookAheadOfAnUnknownWay) {
  const Region field = square(20);
  EXPECT_FALSE(LiveCoverage(field, {}).look_ahead({}));
  EXPECT_FALSE(driven_north(field, 2, 1, std::nan("")).look_ahead({})) << "one fix has no course";
}

}  // namespace
}  // namespace tramline::coverage
