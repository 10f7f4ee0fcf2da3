// Drives that are worked once more: what a reader has at the end is what evaluate() says.

#include "server/work/replay.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "server/work/drives.h"
#include "server/work/replay_cache.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/log/read_log.h"

namespace tramline::server::replay_test {

using namespace testing_drives;
using std::chrono::milliseconds;

std::filesystem::path written(const testing_support::TemporaryFolder& folder, const std::string& text) {
  std::filesystem::path path = folder / "drive.csv";
  std::ofstream(path) << text;
  return path;
}

app::WorkGround ground_here() { return {"here", field_here(), frame_here()}; }

struct Both {
  std::shared_ptr<const ReadyDrive> drive;
  Coverage whole;
};

/// Ready to be replayed, and evaluated.
Both both(const std::string& path, const app::WorkGround& ground, coverage::EvaluateSettings settings = {}) {
  Both out;
  const WorkLog read = io::read_log(path);
  out.drive = std::make_shared<const ReadyDrive>(ready_drive(read, ground, settings));
  app::WorkGround again = ground;
  settings.shapes = true;
  WorkLog placed = app::placed_on(read, again);
  out.whole = coverage::evaluate(std::move(placed), again.ground, settings, {});
  return out;
}

void expect_whole(const Follower& follower, const Coverage& whole) {
  EXPECT_TRUE(follower.ended);
  EXPECT_EQ(follower.end.areas.covered_m2, whole.areas.covered_m2);
  EXPECT_EQ(follower.end.areas.repeated_m2, whole.areas.repeated_m2);
  EXPECT_EQ(follower.end.areas.missed_m2, whole.areas.missed_m2);
  EXPECT_EQ(follower.end.areas.gross_m2, whole.areas.gross_m2);
  const double tolerance_m2 = 1e-6 * std::max(1.0, whole.areas.gross_m2);
  EXPECT_NEAR(follower.covered_m2(), whole.areas.covered_m2, tolerance_m2);
  EXPECT_NEAR(follower.covered_m2(), area(whole.covered), tolerance_m2);
  EXPECT_NEAR(follower.repeated_m2(), area(whole.repeated), tolerance_m2);
  EXPECT_EQ(std::isnan(follower.end.worked_s), std::isnan(whole.worked_s));
  EXPECT_EQ(std::isnan(whole.worked_s) ? 0 : follower.end.worked_s,
            std::isnan(whole.worked_s) ? 0 : whole.worked_s);
}

TEST(Replay, EndsWithWhatEvaluateSaysAtAnySpeedAndFromAnyTime) {
  const testing_support::TemporaryFolder folder;
  const auto [drive, whole] = both(written(folder, joined(csv_lines(1500))), ground_here());
  EXPECT_GT(whole.areas.repeated_m2, 10);
  EXPECT_GT(whole.areas.missed_m2, 10);
  struct Case {
    double from_s, speed;
  };
  const double begin_s = drive->from_s(), end_s = drive->to_s();
  EXPECT_EQ(end_s - begin_s, 1499);
  for (const Case& c : {Case{std::nan(""), 1000}, Case{begin_s + 700, 400}, Case{0, 1000}, Case{end_s - 1, 2},
                        Case{end_s, 1}, Case{end_s + 1000, 0.1}}) {
    SCOPED_TRACE(c.speed);
    Replay replay(drive, c.from_s, c.speed);
    Follower follower;
    follower.follow(replay);
    expect_whole(follower, whole);
    ASSERT_FALSE(follower.frames.empty());
    EXPECT_TRUE(follower.frames.front().changes.all);
    const double from_s = std::isnan(c.from_s) ? begin_s : std::max(c.from_s, begin_s);
    EXPECT_EQ(follower.frames.front().time_s, std::min(from_s, end_s));
    for (std::size_t i = 1; i < follower.frames.size(); ++i) {
      EXPECT_FALSE(follower.frames[i].changes.all);
      EXPECT_GT(follower.frames[i].fix, follower.frames[i - 1].fix);
    }
    EXPECT_EQ(follower.frames.back().fix, 1500U);
    EXPECT_EQ(follower.frames.back().fixes, 1500U);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(replay.next(milliseconds(0))));
  }
}

// At 100 times, 300 s of a log take 3 s: at most ten frames each, and each at its time.
TEST(Replay, KeepsTheTimeOfTheLog) {
  const testing_support::TemporaryFolder folder;
  const auto [drive, whole] = both(written(folder, joined(csv_lines(300))), ground_here());
  Replay replay(drive, std::nan(""), 100);
  Follower follower;
  const auto begin = std::chrono::steady_clock::now();
  follower.follow(replay);
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_GE(took_s, 2.98);
  EXPECT_LT(took_s, 12);  // as far behind as a busy machine may fall
  EXPECT_LE(follower.frames.size(), 32U);
  EXPECT_GE(follower.frames.size(), 15U);
  for (std::size_t i = 1; i < follower.when.size(); ++i)
    EXPECT_GE(follower.when[i] - follower.when[i - 1], milliseconds(95));
  // No fix before its time.
  for (std::size_t i = 0; i < follower.frames.size(); ++i)
    EXPECT_LE(follower.frames[i].time_s - drive->from_s(),
              100 * std::chrono::duration<double>(follower.when[i] - begin).count());
  // Every place once: the first frame has one.
  EXPECT_EQ(follower.places, 300U);
}

TEST(Replay, ASlowReaderGetsFewerAndLargerFrames) {
  const testing_support::TemporaryFolder folder;
  const auto [drive, whole] = both(written(folder, joined(csv_lines(1500))), ground_here());
  Replay quick(drive, std::nan(""), 1000), slow(drive, std::nan(""), 1000);
  Follower often, seldom;
  often.follow(quick);
  seldom.follow(slow, milliseconds(400));
  EXPECT_LT(2 * seldom.frames.size(), often.frames.size());
  expect_whole(seldom, whole);
  EXPECT_EQ(seldom.places, often.places);
}

TEST(Replay, ALogWithoutTimesGoesByTheNumberOfItsFixes) {
  const testing_support::TemporaryFolder folder;
  std::string text = "lon,lat\n";
  for (const Point p : lanes(400)) text += fmt::format("{:.9f},{:.9f}\n", p.x, p.y);
  coverage::EvaluateSettings settings;
  settings.drive.width_m = 6;
  const auto [drive, whole] = both(written(folder, text), ground_here(), settings);
  EXPECT_EQ(drive->from_s(), 0);
  EXPECT_EQ(drive->to_s(), 399);
  Replay replay(drive, 200, 200);
  Follower follower;
  follower.follow(replay);
  EXPECT_EQ(follower.frames.front().fix, 201U);
  EXPECT_TRUE(std::isnan(follower.end.present_m2_per_s));
  expect_whole(follower, whole);
}

TEST(Replay, WithoutAFieldNothingIsMissed) {
  const testing_support::TemporaryFolder folder;
  coverage::EvaluateSettings settings;
  settings.repeat = coverage::RepeatRule::kStrict;
  const auto [drive, whole] = both(written(folder, joined(csv_lines(400))), {}, settings);
  Replay replay(drive, std::nan(""), 1000);
  Follower follower;
  follower.follow(replay);
  EXPECT_FALSE(follower.end.has_field);
  EXPECT_TRUE(std::isnan(remaining_s(follower.end)));
  expect_whole(follower, whole);
}

TEST(ReleaseClock, NeverGoesBackAndBridgesFixesWithoutTime) {
  std::vector<Fix> fixes(6);
  const double nan = std::nan("");
  const std::vector<double> times{nan, 5, nan, 4, 9, nan};
  for (std::size_t i = 0; i < fixes.size(); ++i) fixes[i].time_s = times[i];
  EXPECT_EQ(release_clock(fixes), (std::vector<double>{5, 5, 5, 5, 9, 9}));
  for (Fix& fix : fixes) fix.time_s = nan;
  EXPECT_EQ(release_clock(fixes), (std::vector<double>{0, 1, 2, 3, 4, 5}));
}

TEST(ReadyDrive, RefusesWhatEvaluateRefuses) {
  const testing_support::TemporaryFolder folder;
  const std::string one = written(folder, joined(csv_lines(1)));
  EXPECT_REFUSED(ready_drive(io::read_log(one), {}, {}));
  const std::string no_width = written(folder, "lon,lat\n10.5,52.3\n10.5001,52.3\n10.5002,52.3\n");
  EXPECT_REFUSED(ready_drive(io::read_log(no_width), {}, {}));
  const std::string elsewhere = written(folder, joined(csv_lines(9)));
  app::WorkGround far = ground_here();
  far.frame.origin_lat_deg += 1;
  EXPECT_REFUSED(ready_drive(io::read_log(elsewhere), far, {}));
}

TEST(ReplayCache, KeepsTheLastOnesWithinItsBounds) {
  int made = 0;
  const auto make = [&] {
    ++made;
    ReadyDrive out;
    out.ready.log.fixes.resize(100);
    return out;
  };
  ReplayCache cache(2);
  const auto first = cache.get("a", make);
  EXPECT_EQ(cache.get("a", make), first);
  cache.get("b", make);
  cache.get("a", make);
  cache.get("c", make);  // b goes
  EXPECT_EQ(made, 3);
  EXPECT_EQ(cache.get("a", make), first);
  cache.get("b", make);
  EXPECT_EQ(made, 4);
  cache.forget("b");
  cache.get("b", make);
  EXPECT_EQ(made, 5);
  // What is made while it is forgotten is what it was before.
  cache.get("new", [&] {
    cache.forget("new");
    return make();
  });
  cache.get("new", make);
  EXPECT_EQ(made, 7);
  made = 5;
  ReplayCache small(10, 1);
  small.get("a", make);
  small.get("b", make);
  small.get("a", make);
  EXPECT_EQ(made, 8) << "one at a time fits";
}

// Real logs, where the data folder is there: the end of a replay is evaluate().
TEST(Replay, RealLogsEndWithWhatEvaluateSays) {
  const char* data = std::getenv("TRAMLINE_DATA");
  const std::filesystem::path logs = std::filesystem::path(data == nullptr ? "" : data) / "logs";
  if (data == nullptr || !std::filesystem::is_directory(logs))
    GTEST_SKIP() << "no folder of real logs: set TRAMLINE_DATA";
  struct Case {
    const char* file;
    double width_m;
    const char* columns;
  };
  int replayed = 0;
  for (const Case& c :
       {Case{"isoxml_jdsprayer_TLG00015.csv", 24, ""}, Case{"isoxml_microtrak_TLG00004.csv", 18, ""},
        Case{"isoxml_sh2020_TLG00001.csv", 6, ""}, Case{"yield_gartner_corn_mn.csv", 6, ""},
        Case{"yield_pyprecag_area2_grain.csv", 9, ""}, Case{"yield_ofpe_millview_oats_2017.csv.gz", 9, ""}}) {
    const std::filesystem::path path = logs / c.file;
    if (!std::filesystem::exists(path)) {
      std::cout << "skipped, not there: " << c.file << "\n";
      continue;
    }
    SCOPED_TRACE(c.file);
    coverage::EvaluateSettings settings;
    settings.drive.width_m = c.width_m;
    try {
      const auto [drive, whole] = both(path, {}, settings);
      // From a while before the end: all that lies before comes in the first frame.
      Replay replay(drive, drive->to_s() - 1000, 1000);
      Follower follower;
      follower.follow(replay);
      expect_whole(follower, whole);
      std::cout << c.file << ": " << drive->clock_s.size() << " fixes, " << follower.frames.size()
                << " frames\n";
      ++replayed;
    } catch (const Error& error) {
      std::cout << "skipped, cannot be evaluated: " << error.what() << "\n";
    }
  }
  EXPECT_GE(replayed, 3);
}

}  // namespace tramline::server::replay_test
