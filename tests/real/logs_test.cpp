// Real logs of machines, and the same logs decoded by other software.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/log/read_log.h"

namespace tramline {
namespace {

using namespace io;

std::filesystem::path data_folder() {
  const char* named = std::getenv("TRAMLINE_DATA");
  if (named != nullptr && *named != '\0') return named;
  return std::filesystem::path(TRAMLINE_SOURCE_DIR).parent_path() / "shared" / "data";
}

class RealLogs : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(data_folder() / "logs"))
      GTEST_SKIP() << "there are no real logs in " << data_folder() << "; set TRAMLINE_DATA to their folder";
  }
  static std::string file(const std::string& name) { return (data_folder() / name).string(); }
};

/// Whole width, metres; NaN: not recorded.
double width_m(const WorkLog& log, const Fix& fix) {
  if (fix.boom < 0) return std::nan("");
  const Boom& boom = log.booms[static_cast<std::size_t>(fix.boom)];
  return boom.empty() ? 0 : boom.front().left_m - boom.back().right_m;
}

bool equal_or_both_nan(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST_F(RealLogs, TimeLogsAreWhatOtherSoftwareDecodedThemTo) {
  std::size_t compared = 0;
  for (int i = 1; i <= 9; ++i) {
    const std::string name = "TLG0000" + std::to_string(i);
    SCOPED_TRACE(name);
    const WorkLog log = read_log(file("isoxml/forage-harvester"), {"", "", name});
    const WorkLog table = read_log(file("logs/isoxml_sh2020_" + name + ".csv"));
    ASSERT_EQ(log.fixes.size(), table.fixes.size());
    EXPECT_EQ(log.clock, table.clock);
    for (std::size_t k = 0; k < log.fixes.size(); ++k) {
      const Fix& a = log.fixes[k];
      const Fix& b = table.fixes[k];
      ASSERT_NEAR(a.time_s, b.time_s, 1e-6) << k;
      ASSERT_NEAR(a.position.x, b.position.x, 0.5e-7) << k;
      ASSERT_NEAR(a.position.y, b.position.y, 0.5e-7) << k;
      ASSERT_EQ(a.work, b.work) << k;
      ASSERT_TRUE(equal_or_both_nan(width_m(log, a), width_m(table, b))) << k;
      ++compared;
    }
  }
  // The points that the tables' own list counts.
  EXPECT_EQ(compared, 4716U + 4135 + 1599 + 2496 + 1785 + 187 + 3883 + 4952 + 4497);
}

TEST_F(RealLogs, ATaskSetIsItsLogsOneAfterTheOther) {
  const WorkLog all = read_log(file("isoxml/forage-harvester/TASKDATA"));
  EXPECT_EQ(all.fixes.size(), 28250U);
  std::set<int> units;
  for (const Fix& fix : all.fixes) units.insert(fix.unit);
  EXPECT_EQ(units.size(), 9U);
  const auto logs = list_logs(file("isoxml/forage-harvester"));
  ASSERT_GE(logs.size(), 9U);
  EXPECT_EQ(logs[0].name, "TLG00001");
  EXPECT_EQ(logs[0].task_id, "TSK1");
  EXPECT_EQ(logs[0].field_id, "PFD-2");
}

// Nine logs on eight fields. The totals are those that the task set itself gives for each task (TIM): area in
// m², way at work in mm, time at work in s. The machine writes them down every 100 m² and a few seconds.
TEST_F(RealLogs, ATaskSetOfEightJobsCountsWhatItsTasksSay) {
  const std::vector<LogJob> jobs = read_jobs(file("isoxml/forage-harvester"));
  ASSERT_EQ(jobs.size(), 8U);
  const std::vector<std::array<double, 3>> totals = {
      {48300, 5503990, 3559}, {40500, 4602412, 3135}, {19500, 2224858, 1370}, {30100, 3529801, 2283},
      {17900, 2127845, 1545}, {52000, 5902654, 3490}, {65000, 7585003, 3868}, {48200, 5448311, 3545}};
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    SCOPED_TRACE(i);
    const MachineCounters& counters = jobs[i].log.counters;
    EXPECT_NEAR(counters.area_m2, totals[i][0], 200);
    EXPECT_NEAR(counters.distance_m, totals[i][1] / 1000, 40);
    EXPECT_NEAR(counters.seconds, totals[i][2], 20);
    EXPECT_EQ(jobs[i].entries.size(), i == 5 ? 2U : 1U);
    EXPECT_EQ(jobs[i].entries[0].field_id, "PFD-" + std::to_string(i + 2));
  }
}

TEST_F(RealLogs, SectionsOfASprayer) {
  const std::string zip = file("isoxml/zips/jd-sprayer-short.zip");
  const WorkLog log = read_log(zip, {"", "", "TLG00016"});
  // Its offsets (135) are logged in the first record: 13.5, 10.5, 6.75, 3, 0 m to the right and the same to
  // the left.
  ASSERT_EQ(log.booms.size(), 1U);
  EXPECT_EQ(log.booms[0], (Boom{{15, 12},
                                {12, 9},
                                {9, 4.5},
                                {4.5, 1.5},
                                {1.5, -1.5},
                                {-1.5, -4.5},
                                {-4.5, -9},
                                {-9, -12},
                                {-12, -15}}));
  // Another log of this machine, in which the same boom is listed section by section.
  const WorkLog table = read_log(file("logs/isoxml_jdsprayer_TLG00015.csv"));
  ASSERT_EQ(table.booms.size(), 1U);
  EXPECT_EQ(table.booms[0], log.booms[0]);
  for (const LogEntry& entry : list_logs(zip))
    EXPECT_NO_THROW(read_log(zip, {"", "", entry.name})) << entry.name;
  try {
    read_log(file("isoxml/zips/task_full.zip"));
    FAIL() << "a task set without logs was read as one";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no time log"), std::string::npos) << error.what();
  }
}

TEST_F(RealLogs, AllAreRead) {
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "logs")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".csv") && !name.ends_with(".csv.gz")) continue;
    SCOPED_TRACE(name);
    const WorkLog log = read_log(entry.path().string());
    EXPECT_GT(log.fixes.size(), 100U);
    EXPECT_EQ(log.positions, Positions::kLonLat);
    EXPECT_NE(log.clock, Clock::kNone);
    if (name.find("TLG0006") == std::string::npos) {
      EXPECT_EQ(log.skipped.count, 0U);
    }
  }
}

TEST_F(RealLogs, ADamagedLogTellsWhatItSkips) {
  const WorkLog log = read_log(file("logs/isoxml_corruptstream_TLG0006.csv.gz"));
  EXPECT_EQ(log.fixes.size() + log.skipped.count, 26666U);
  // Counted by hand: the records of lines 3 to 23 are the damaged ones.
  ASSERT_EQ(log.skipped.count, 21U);
  for (std::size_t i = 0; i < 21; ++i) EXPECT_EQ(log.skipped.listed[i].record, 3 + i);
  for (const Fix& fix : log.fixes) {
    EXPECT_NEAR(fix.position.x, 7.575, 0.01);
    EXPECT_NEAR(fix.position.y, 52.437, 0.01);
  }
}

// Positions of rows with the same time lie as far apart as the sections are wide.
TEST_F(RealLogs, SectionsOfACombineAreUnitsAsWideAsTheyAreApart) {
  const WorkLog log = read_log(file("logs/yield_ofpe_millview_oats_2017.csv.gz"));
  EXPECT_EQ(log.fixes.size(), 97383U);
  ASSERT_EQ(log.booms.size(), 1U);
  const double width = log.booms[0].front().left_m - log.booms[0].front().right_m;
  EXPECT_NEAR(width, 1.8288, 1e-3);  // six feet: two rows of plants
  std::map<int, std::size_t> by_unit;
  std::vector<double> apart;
  for (std::size_t i = 1; i < log.fixes.size(); ++i) {
    const Fix& a = log.fixes[i - 1];
    const Fix& b = log.fixes[i];
    ++by_unit[a.unit];
    if (a.time_s != b.time_s) continue;
    EXPECT_NE(a.unit, b.unit);
    const double north = (b.position.y - a.position.y) * 111200;
    const double east = (b.position.x - a.position.x) * 111320 * std::cos(a.position.y * 3.14159265 / 180);
    apart.push_back(std::hypot(north, east));
  }
  EXPECT_EQ(by_unit.size(), 12U);
  std::nth_element(apart.begin(), apart.begin() + std::ssize(apart) / 2, apart.end());
  EXPECT_NEAR(apart[apart.size() / 2], width, 0.02);
}

TEST_F(RealLogs, ASeederInFeet) {
  const WorkLog log = read_log(file("logs/seeding_ofpe_millview_wheat_2019.csv.gz"));
  std::set<int> millimetres;
  for (const Fix& fix : log.fixes)
    millimetres.insert(static_cast<int>(std::lround(width_m(log, fix) * 1000)));
  EXPECT_EQ(millimetres, (std::set<int>{9601, 13200}));  // 31.5 ft and 43.307 ft
}

TEST_F(RealLogs, PartfieldsOfTheTaskSets) {
  const RawDataset fields = read_partfields(file("isoxml/forage-harvester"));
  const auto find = [&](const std::string& id) {
    const auto& features = fields.layers.at(0).features;
    const auto at =
        std::find_if(features.begin(), features.end(), [&](const RawFeature& f) { return f.id == id; });
    EXPECT_NE(at, features.end()) << id;
    return *at;
  };
  ASSERT_EQ(find("PFD-2").polygons.size(), 1U);
  EXPECT_EQ(find("PFD-2").polygons[0].rings[0].points.size(), 15U);
  EXPECT_EQ(find("PFD-2").polygons[0].rings[0].points[0], (Point{10.209195754, 54.580684068}));
  const RawDataset sprayed = read_partfields(file("isoxml/zips/jd-sprayer-short.zip"));
  const RawFeature& with_holes = sprayed.layers.at(0).features.at(1);
  ASSERT_EQ(with_holes.polygons.size(), 1U);
  EXPECT_EQ(with_holes.polygons[0].rings.size(), 4U);
  EXPECT_TRUE(with_holes.polygons[0].rings[0].closed);
  EXPECT_EQ(read_partfields(file("isoxml/guidance/TASKDATA.XML")).layers.at(0).features.size(), 1U);
}

}  // namespace
}  // namespace tramline
