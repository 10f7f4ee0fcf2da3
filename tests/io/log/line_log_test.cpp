// Logs that come line by line: at every moment what read_log() makes of the same lines in a file.

#include "tramline/io/log/line_log.h"
#include "support/refusals.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/vector/files.h"
#include "tramline/geometry/error.h"

namespace tramline::io::line_log_test {

class LineLogs : public testing_files::Files {
 protected:
  WorkLog as_file(const std::vector<std::string>& lines) const {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return read_log(write("log.txt", text));
  }
};

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}", body, sum);
}
std::string gga(int second, double minutes = 7.038) {
  return sentence(
      fmt::format("GPGGA,1000{:02},48{:09.6f},N,01131.000,E,4,08,0.9,545.4,M,46.9,M,,", second, minutes));
}
std::string rmc(int second) {
  return sentence(fmt::format("GPRMC,1000{:02},A,4807.038000,N,01131.000,E,3.0,084.4,060526,,,A", second));
}

void expect_same(const std::vector<Fix>& a, const std::vector<Fix>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(a[i].position, b[i].position);
    EXPECT_TRUE(a[i].time_s == b[i].time_s || (std::isnan(a[i].time_s) && std::isnan(b[i].time_s)));
    EXPECT_EQ(a[i].work, b[i].work);
    EXPECT_EQ(a[i].has_sections, b[i].has_sections);
    EXPECT_EQ(a[i].sections, b[i].sections);
    EXPECT_EQ(a[i].boom, b[i].boom);
    EXPECT_EQ(a[i].record, b[i].record);
  }
}

/// What came out, with what was read anew where that was asked for; at the end the same as from the file.
void expect_stream_is_file(const std::vector<std::string>& lines, const WorkLog& file) {
  LineLog log({}, "the stream");
  std::vector<Fix> fixes;
  for (const std::string& line : lines) {
    for (const Fix& fix : log.add(line)) fixes.push_back(fix);
    if (log.urgent()) fixes = log.settle().fixes;
  }
  for (const Fix& fix : log.finish()) fixes.push_back(fix);
  const bool doubtful = log.doubtful();
  if (!doubtful) expect_same(fixes, file.fixes);
  EXPECT_EQ(log.head().skipped.count + (doubtful ? 1000 : 0) >= file.skipped.count, true);
  const WorkLog whole = log.settle();
  expect_same(whole.fixes, file.fixes);
  EXPECT_EQ(whole.booms, file.booms);
  EXPECT_EQ(whole.clock, file.clock);
  EXPECT_EQ(whole.positions, file.positions);
  EXPECT_EQ(whole.notes, file.notes);
  EXPECT_EQ(log.head().notes, file.notes);
  EXPECT_EQ(log.head().skipped.count, file.skipped.count);
}

TEST_F(LineLogs, ATable) {
  const std::vector<std::string> lines{"sep=;",         "lon;lat;time;width_m;work", "9,15;52,69;0;4;1",
                                       "9,15;99;1;4;1", "9,1501;52,69;2;4;0",        "no;row;3;4;1"};
  expect_stream_is_file(lines, as_file(lines));
}

TEST_F(LineLogs, SentencesWhoseDateComesLate) {
  const std::vector<std::string> lines{gga(1), gga(2), gga(3), rmc(3), gga(4), rmc(4)};
  const WorkLog file = as_file(lines);
  EXPECT_EQ(file.clock, Clock::kUtc);
  expect_stream_is_file(lines, file);
}

TEST_F(LineLogs, XAndYThatTurnOutToBeMetres) {
  std::vector<std::string> lines{"x,y,time"};
  for (int i = 0; i < 200; ++i) lines.push_back(fmt::format("{},{},{}", 0.5 + 0.1 * i, 3, i));
  const WorkLog file = as_file(lines);
  EXPECT_EQ(file.positions, Positions::kLocal);
  expect_stream_is_file(lines, file);
}

TEST_F(LineLogs, WidthsWhoseUnitTheDistancesTell) {
  // 1.1132 m north at each step are 3.652 feet.
  std::vector<std::string> lines{"lon,lat,swath,distance"};
  for (int i = 0; i < 60; ++i) lines.push_back(fmt::format("9.15,{:.7f},30,3.652", 52.69 + 1e-5 * i));
  const WorkLog file = as_file(lines);
  EXPECT_NEAR(file.booms.at(0).at(0).left_m, 15 * 0.3048, 1e-9);
  expect_stream_is_file(lines, file);
}

TEST_F(LineLogs, AStrayIsFoundWhenTheLogIsReadAnew) {
  const std::vector<std::string> lines{"lon,lat", "9.15,52.69", "9.1501,52.69", "9.1,12.69", "9.1502,52.69"};
  const WorkLog file = as_file(lines);
  EXPECT_EQ(file.skipped.count, 1U);
  LineLog log({}, "the stream");
  for (const std::string& line : lines) log.add(line);
  EXPECT_TRUE(log.doubtful());
  expect_stream_is_file(lines, file);
}

TEST_F(LineLogs, WorkAsLinesSayIt) {
  const std::vector<std::string> lines{gga(1),     gga(2), "#work=0",     gga(3),
                                       "#!work=1", gga(4), "#work=maybe", gga(5)};
  const WorkLog file = as_file(lines);
  std::string states;
  for (const Fix& fix : file.fixes)
    states += fix.work == WorkState::kOn ? '1' : fix.work == WorkState::kOff ? '0' : '?';
  EXPECT_EQ(states, "11011") << "before the first line on work it is on";
  EXPECT_EQ(file.skipped.count, 1U);
  expect_stream_is_file(lines, file);
}

TEST_F(LineLogs, SectionsAndWidthsAsLinesSayThem) {
  const std::vector<std::string> lines{"#width=3|4|5", "#sections=101", gga(1),       gga(2), "#width=9",
                                       gga(3),         gga(4),          "#sections=", gga(5)};
  const WorkLog file = as_file(lines);
  ASSERT_EQ(file.fixes.size(), 5U);
  const Fix& apart = file.fixes[0];
  EXPECT_EQ(file.booms.at(static_cast<std::size_t>(apart.boom)), (Boom{{6, 3}, {3, -1}, {-1, -6}}));
  EXPECT_TRUE(apart.has_sections && apart.sections[0] && !apart.sections[1] && apart.sections[2]);
  // One width for three sections: a third each.
  EXPECT_EQ(file.booms.at(static_cast<std::size_t>(file.fixes[2].boom)),
            (Boom{{4.5, 1.5}, {1.5, -1.5}, {-1.5, -4.5}}));
  EXPECT_FALSE(file.fixes[4].has_sections);
  expect_stream_is_file(lines, file);
}

TEST_F(LineLogs, ATableWithAColumnForWorkIsNotOverruled) {
  const std::vector<std::string> lines{"lon,lat,work", "9.15,52.69,1", "#work=0", "9.1501,52.69,1"};
  const WorkLog file = as_file(lines);
  EXPECT_EQ(file.fixes.at(1).work, WorkState::kOn);
  expect_stream_is_file(lines, file);
}

TEST_F(LineLogs, AHeaderThatComesAgainIsNoRow) {
  const std::vector<std::string> lines{"lon,lat", "9.15,52.69", "lon,lat", "9.1501,52.69"};
  EXPECT_EQ(as_file(lines).skipped.count, 0U);
  expect_stream_is_file(lines, as_file(lines));
}

TEST_F(LineLogs, TheEndOfASentenceBeforeTheFirstWhole) {
  const std::vector<std::string> lines{"131.000,E,4,08,0.9,545.4,M,46.9,M,,*47", gga(1), gga(2)};
  expect_stream_is_file(lines, as_file(lines));
}

TEST_F(LineLogs, WhatIsNeitherIsRefused) {
  LineLog log({}, "the stream");
  EXPECT_REFUSED({
    for (int i = 0; i < 2000; ++i) log.add("a,b,c");
  });
}

}  // namespace tramline::io::line_log_test
