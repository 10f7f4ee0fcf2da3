// Good logs with bytes changed, lost and cut: a log or a sentence, never a crash and never without end.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "io/isoxml/time_log_bytes.h"
#include "io/vector/files.h"
#include "tramline/geometry/error.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/isoxml/time_log.h"
#include "tramline/io/log/csv_log.h"
#include "tramline/io/log/gpx_log.h"
#include "tramline/io/log/nmea_log.h"
#include "tramline/io/log/read_log.h"

namespace tramline::io {
namespace {

using testing_logs::header;
using testing_logs::record;

int cases() {
  const char* named = std::getenv("TRAMLINE_CASES");
  return named != nullptr ? std::atoi(named) : 300;
}

std::string damaged(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::size_t changes = 1 + below(8);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 2:
        bytes.erase(at, 1 + below(20));
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        break;
      default:
        if (below(4) == 0) bytes.resize(at);
    }
  }
  return bytes;
}

// Whatever comes out has to make sense: fixes with places, booms that there are.
void expect_sound(const WorkLog& log) {
  EXPECT_FALSE(log.fixes.empty());
  EXPECT_GE(log.skipped.count, log.skipped.listed.size());
  for (const Fix& fix : log.fixes) {
    EXPECT_TRUE(std::isfinite(fix.position.x) && std::isfinite(fix.position.y));
    EXPECT_LT(fix.boom, static_cast<int>(log.booms.size()));
    EXPECT_GE(fix.unit, 0);
    EXPECT_GT(fix.record, 0U);
    if (log.positions == Positions::kLonLat) {
      EXPECT_LE(std::abs(fix.position.x), 180);
      EXPECT_LE(std::abs(fix.position.y), 90);
    }
  }
  for (const Boom& boom : log.booms)
    for (const Section& section : boom) EXPECT_GE(section.left_m, section.right_m);
}

void try_damaged(const std::string& good, const std::function<WorkLog(const std::string&)>& read) {
  expect_sound(read(good));
  int read_anyway = 0;
  for (int seed = 1; seed <= cases(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(static_cast<unsigned>(seed));
    const std::string bytes = damaged(good, random);
    try {
      const WorkLog log = read(bytes);
      ++read_anyway;
      if (!log.fixes.empty()) expect_sound(log);
    } catch (const Error& error) {
      EXPECT_GT(std::string(error.what()).size(), 10U);
    }
  }
  EXPECT_GT(read_anyway, 0);
}

TEST(DamagedLogs, Csv) {
  std::string good = "time;lon;lat;heading;speed;width_mm;sections;sections_condensed;machine\n";
  for (int i = 0; i < 30; ++i)
    good += "2020-01-02T10:00:" + std::to_string(10 + i) + "Z;10,5" + std::to_string(i) +
            ";52,25;90;1,5;3000|3000;01;0xFFFFFFF1;\"A \"\"1\"\"\"\n";
  try_damaged(good, [](const std::string& bytes) {
    TextLines lines(bytes);
    return read_csv_log(lines, "", "", "'t'");
  });
}

TEST(DamagedLogs, Nmea) {
  std::string good;
  for (int i = 0; i < 20; ++i)
    good +=
        "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n"
        "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n";
  try_damaged(good, [](const std::string& bytes) {
    TextLines lines(bytes);
    return read_nmea_log(lines, "'t'");
  });
}

TEST(DamagedLogs, Gpx) {
  std::string good = "<gpx><trk><trkseg>";
  for (int i = 0; i < 20; ++i)
    good += "<trkpt lat='52.25' lon='10.5" + std::to_string(i) +
            "'><time>2020-01-02T17:30:20Z</time><extensions><speed>2</speed></extensions></trkpt>";
  good += "</trkseg></trk></gpx>";
  try_damaged(good, [](const std::string& bytes) { return read_gpx_log(bytes, "'t'"); });
}

std::string good_records() {
  std::string out;
  for (int i = 0; i < 40; ++i)
    out += record(static_cast<std::uint32_t>(60000000 + 1000 * i), 14611, 520000000 + 100 * i, 100000000, 4,
                  {{0, i % 2}, {1, 3000 + i}, {2, 0x11}});
  return out;
}
const std::string kHeader =
    header(R"(<DLV A="008D" B="" C="DET-1"/><DLV A="0043" B="" C="DET-2"/><DLV A="00A1" B="" C="DET-1"/>)");
std::vector<DeviceElement> elements() {
  return {{"DET-1", "DVC-1", 1, 0, 0, 1, {}},
          {"DET-2", "DVC-1", 4, 1, 1, 2, {{67, 3000}, {135, -1500}}},
          {"DET-3", "DVC-1", 4, 2, 1, 3, {{67, 3000}, {135, 1500}}}};
}

TEST(DamagedLogs, RecordsOfTimeLogs) {
  try_damaged(good_records(),
              [](const std::string& bytes) { return decode_time_log(kHeader, bytes, elements(), "'t'"); });
}

TEST(DamagedLogs, HeadersOfTimeLogs) {
  const std::string records = good_records();
  try_damaged(kHeader,
              [&](const std::string& xml) { return decode_time_log(xml, records, elements(), "'t'"); });
}

const std::string kTaskData =
    R"(<ISO11783_TaskData><PFD A="PFD1"><PLN A="1"><LSG A="1"><PNT C="52" D="10"/><PNT C="52" D="10.01"/>)"
    R"(<PNT C="52.01" D="10.01"/></LSG></PLN></PFD><DVC A="DVC-1"><DET A="DET-1" B="1" C="1" E="0" F="0"/>)"
    R"(<DET A="DET-2" B="2" C="4" E="1" F="1"><DOR A="9"/></DET><DPT A="9" B="0087" C="1500"/></DVC>)"
    R"(<TSK A="TSK1" E="PFD1"><TLG A="TLG00001"/></TSK></ISO11783_TaskData>)";

TEST(DamagedLogs, TaskData) {
  const std::string records = good_records();
  try_damaged(kTaskData, [&](const std::string& xml) {
    const auto none = [](const std::string&) { return std::optional<std::string>(); };
    return decode_time_log(kHeader, records, parse_task_data(xml, none, "t").elements, "'t'");
  });
}

class DamagedZips : public testing_files::Files {};

TEST_F(DamagedZips, OfTaskSets) {
  testing_files::write_zip(path("good.zip"), {{"TASKDATA/TASKDATA.XML", kTaskData},
                                              {"TASKDATA/TLG00001.xml", kHeader},
                                              {"TASKDATA/TLG00001.bin", good_records()}});
  int number = 0;
  try_damaged(bytes_of(path("good.zip")), [&](const std::string& bytes) {
    // GDAL remembers what a zip of the same name held.
    return read_log(write(std::to_string(number++) + ".zip", bytes));
  });
}

}  // namespace
}  // namespace tramline::io
