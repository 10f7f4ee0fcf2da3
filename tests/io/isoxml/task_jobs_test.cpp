// Several logs of a task set: which are one job, and what their machines counted.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "io/isoxml/time_log_bytes.h"
#include "io/vector/files.h"
#include "support/refusals.h"
#include "tramline/io/fixes/counter_total.h"
#include "tramline/io/fixes/job_groups.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/log/read_log.h"

namespace tramline::task_jobs_test {

using namespace io;
using testing_logs::header;
using testing_logs::record;
using testing_support::mentions;

constexpr std::uint32_t kDay = 14611;  // 2020-01-02, 18,263 days after 1970-01-01
constexpr double kDay_s = 18263 * 86400.0;

JobFacts facts(const std::string& field, const std::string& device, double day, double lon) {
  JobFacts out;
  out.field_id = field;
  if (!device.empty()) out.devices = {device};
  out.from_s = kDay_s + 86400 * day + 8 * 3600;
  out.to_s = out.from_s + 4 * 3600;
  // 0.001° are 68 m at 52° north.
  out.lonlat = {lon, 52, lon + 0.001, 52.001};
  return out;
}

TEST(JobGroups, SameLandMachineAndDaysAreOneJob) {
  const JobFacts first = facts("PFD1", "DVC-1", 0, 10);
  EXPECT_TRUE(belong_together(first, facts("PFD1", "DVC-1", 0, 10)));
  EXPECT_TRUE(belong_together(first, facts("PFD1", "DVC-1", 1, 10)));
  EXPECT_FALSE(belong_together(first, facts("PFD1", "DVC-1", 2, 10)));
  EXPECT_FALSE(belong_together(first, facts("PFD2", "DVC-1", 0, 10)));
  EXPECT_FALSE(belong_together(first, facts("PFD1", "DVC-2", 0, 10)));
  EXPECT_TRUE(belong_together(first, facts("PFD1", "", 0, 10)));
}

TEST(JobGroups, LandWithoutANameIsTheSameWhereItIsNear) {
  const JobFacts first = facts("", "DVC-1", 0, 10);
  // 0.002° further on begins 68 m away, 0.005° 274 m away.
  EXPECT_TRUE(belong_together(first, facts("PFD1", "DVC-1", 0, 10.002)));
  EXPECT_FALSE(belong_together(first, facts("PFD1", "DVC-1", 0, 10.005)));
  // Named alike, it may lie further away, but not 3 km.
  EXPECT_TRUE(belong_together(facts("PFD1", "", 0, 10), facts("PFD1", "", 0, 10.005)));
  EXPECT_FALSE(belong_together(facts("PFD1", "", 0, 10), facts("PFD1", "", 0, 10.05)));
  // Across the 180th meridian.
  EXPECT_TRUE(belong_together(facts("", "", 0, 179.9985), facts("", "", 0, -179.9995)));
}

TEST(JobGroups, OneLogLeadsToTheNext) {
  const std::vector<JobFacts> logs = {facts("A", "", 0, 10), facts("B", "", 0, 11), facts("A", "", 2, 10),
                                      facts("A", "", 1, 10)};
  const std::vector<std::vector<std::size_t>> expected = {{0, 2, 3}, {1}};
  EXPECT_EQ(job_groups(logs), expected);
}

TEST(CounterTotal, CountersRunOnAndAreReset) {
  CounterTotal counter;
  EXPECT_TRUE(std::isnan(counter.total()));
  counter.add(500);
  EXPECT_TRUE(std::isnan(counter.total()));
  for (const double reading : {520.0, -1.0, std::nan(""), 600.0, 0.0, 30.0}) counter.add(reading);
  EXPECT_DOUBLE_EQ(counter.total(), 130);
}

class TaskJobs : public testing_files::Files {
 protected:
  void write_log(const std::string& name, std::uint32_t day, std::int32_t lon,
                 std::int32_t counted_m2) const {
    write(name + ".xml", header(R"(<DLV A="0043" B="" C="DET-1"/><DLV A="0074" B="" C="DET-1"/>)"
                                R"(<DLV A="0077" B="" C="DET-1"/><DLV A="0075" B="" C="DET-1"/>)"));
    std::string bytes;
    for (int i = 0; i < 3; ++i)
      bytes += record(static_cast<std::uint32_t>(30000000 + 1000 * i), day, 520000000 + 100 * i, lon, 4,
                      {{0, 3000}, {1, 1000 + i * counted_m2 / 2}, {2, 10 + i}, {3, 5000 * i}});
    write(name + ".bin", bytes);
  }
};

TEST_F(TaskJobs, LogsOfOtherFieldsAndDaysAreJobsOfTheirOwn) {
  write("TASKDATA.XML",
        R"(<ISO11783_TaskData><DVC A="DVC-1" B="Harrow"><DET A="DET-1" B="1" C="1" F="0"/></DVC>)"
        R"(<TSK A="TSK1" B="spring" E="PFD1"><TLG A="TLG00001"/><TLG A="TLG00002"/></TSK>)"
        R"(<TSK A="TSK2" B="autumn" E="PFD2"><TLG A="TLG00003"/></TSK></ISO11783_TaskData>)");
  write_log("TLG00001", kDay, 100000000, 200);
  write_log("TLG00002", kDay + 1, 100000100, 300);
  write_log("TLG00003", kDay, 130000000, 400);
  const std::vector<LogJob> jobs = read_jobs(path("TASKDATA.XML"));
  ASSERT_EQ(jobs.size(), 2U);
  ASSERT_EQ(jobs[0].entries.size(), 2U);
  EXPECT_EQ(jobs[0].entries[1].name, "TLG00002");
  EXPECT_EQ(jobs[0].devices, std::vector<std::string>{"Harrow"});
  EXPECT_EQ(jobs[0].log.fixes.size(), 6U);
  EXPECT_DOUBLE_EQ(jobs[0].from_s, kDay_s + 30000);
  EXPECT_DOUBLE_EQ(jobs[0].to_s, kDay_s + 86400 + 30002);
  // The counters of the two logs together: 200 and 300 m², twice 2 s, twice 10 m.
  EXPECT_DOUBLE_EQ(jobs[0].log.counters.area_m2, 500);
  EXPECT_DOUBLE_EQ(jobs[0].log.counters.seconds, 4);
  EXPECT_DOUBLE_EQ(jobs[0].log.counters.distance_m, 20);
  EXPECT_EQ(jobs[1].entries[0].task_name, "autumn");
  EXPECT_TRUE(mentions(jobs[1].log.name, "TLG00003"));
  // Far apart as they are, nothing is a stray: each log is judged by itself.
  EXPECT_EQ(jobs[1].log.fixes.size(), 3U);
  EXPECT_EQ(jobs[1].log.skipped.count, 0U);
  EXPECT_EQ(read_jobs(path("TASKDATA.XML"), {"", "", "TLG00003"}).size(), 1U);
}

TEST_F(TaskJobs, TracksOfAGpxFileFarApartAreJobs) {
  const auto track = [](const std::string& lon) {
    std::string out = "<trk><name>at " + lon + "</name><trkseg>";
    for (int i = 0; i < 5; ++i)
      out += "<trkpt lat=\"52.0000" + std::to_string(i) + "\" lon=\"" + lon + "\"><time>2020-01-02T08:00:0" +
             std::to_string(i) + "Z</time></trkpt>";
    return out + "</trkseg></trk>";
  };
  const std::string file = write("day.gpx", "<gpx>" + track("10") + track("10.001") + track("14") + "</gpx>");
  const std::vector<LogJob> jobs = read_jobs(file);
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0].log.fixes.size(), 10U);
  EXPECT_EQ(jobs[1].log.fixes.size(), 5U);
  EXPECT_EQ(jobs[1].entries[0].name, "at 14");
  EXPECT_EQ(read_log(file).fixes.size(), 15U);
}

}  // namespace tramline::task_jobs_test
