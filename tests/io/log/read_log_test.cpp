// Files of all kinds through one door.

#include "tramline/io/log/read_log.h"
#include "support/refusals.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <zlib.h>

#include <cmath>
#include <string>

#include "io/vector/files.h"
#include "tramline/geometry/error.h"
#include "tramline/io/fixes/lines.h"

namespace tramline::read_log_test {

using testing_support::mentions;
using testing_support::refusal_of;

using namespace io;

class ReadLog : public testing_files::Files {
 protected:
  std::string write_gz(const std::string& name, const std::string& bytes, std::size_t times = 1) const {
    const gzFile file = gzopen(path(name).c_str(), "wb9");
    for (std::size_t i = 0; i < times; ++i) gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
    return path(name);
  }

  static std::string refusal(const std::string& file, const LogOptions& options = {}) {
    return refusal_of([&] { read_log(file, options); });
  }
};

const std::string kCsv = "lon,lat\n10.5,52.25\n10.6,52.25\n";
const std::string kGga = "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\n";

TEST_F(ReadLog, TheContentTellsTheFormat) {
  EXPECT_EQ(read_log(write("a.csv", kCsv)).fixes.size(), 2U);
  EXPECT_EQ(read_log(write("b.txt", kCsv)).fixes.size(), 2U);
  EXPECT_EQ(read_log(write("c.txt", kGga)).fixes.size(), 1U);
  EXPECT_EQ(read_log(write("d.log", "started\n" + kGga)).fixes.size(), 1U);
  EXPECT_EQ(read_log(write("e.xml", "<gpx><trk><trkseg><trkpt lat='1' lon='2'/></trkseg></trk></gpx>"))
                .fixes.size(),
            1U);
  EXPECT_EQ(read_log(write_gz("f.csv.gz", kCsv)).fixes.size(), 2U);
  EXPECT_EQ(read_log(write_gz("g.nmea.gz", kGga)).fixes.size(), 1U);
  EXPECT_EQ(read_log(path("a.csv")).name, path("a.csv"));
}

TEST_F(ReadLog, WhatIsNoLogIsRefused) {
  EXPECT_TRUE(mentions(refusal(path("none.csv")), "no file"));
  EXPECT_TRUE(mentions(refusal(write("empty.csv", "")), "empty"));
  EXPECT_TRUE(mentions(refusal(write("a.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\r", 12))),
                       "not a known kind of log"));
  EXPECT_TRUE(mentions(refusal(write("a.html", "<html>")), "not a known kind of log"));
  EXPECT_TRUE(mentions(refusal(path("")), "Shapefile"));  // a folder without anything
  EXPECT_TRUE(mentions(refusal(write("a.csv", kCsv), {"", "", "TLG00001"}), "--log"));
  EXPECT_TRUE(mentions(refusal(write("a.nmea", kGga), {"lon=x", "", ""}), "--columns"));
}

TEST_F(ReadLog, ACutOffGzIsReadAsFarAsItGoes) {
  std::string rows = "lon,lat\n";
  for (int i = 0; i < 20000; ++i) rows += "10.5," + std::to_string(52 + i * 1e-6) + "\n";
  const std::string whole = bytes_of(write_gz("a.csv.gz", rows));
  const WorkLog log = read_log(write("b.csv.gz", whole.substr(0, whole.size() / 2)));
  EXPECT_GT(log.fixes.size(), 1000U);
  EXPECT_LT(log.fixes.size(), 20000U);
  ASSERT_FALSE(log.notes.empty());
  EXPECT_TRUE(mentions(log.notes.back(), "cut off")) << log.notes.back();
}

TEST_F(ReadLog, AGzThatExpandsWithoutEndIsRefused) {
  // Five megabytes of comments are a few kilobytes packed.
  const std::string file = write_gz("bomb.csv.gz", std::string(1U << 16, '#') + "\n", 80);
  FileLines lines(file, std::size_t{1} << 22);
  std::string line;
  std::size_t count = 0;
  try {
    while (lines.next(line)) ++count;
    FAIL() << count << " lines were read";
  } catch (const Error& error) {
    EXPECT_TRUE(mentions(error.what(), "more than 4 MiB")) << error.what();
  }
  EXPECT_GE(count, 60U);
}

TEST_F(ReadLog, ALineWithoutEndIsRefused) {
  const std::string sentence = refusal(write_gz("line.csv.gz", std::string(1U << 20, 'x'), 4));
  EXPECT_TRUE(mentions(sentence, "line longer")) << sentence;
}

TEST_F(ReadLog, PointsOfAGeoJson) {
  const std::string points = R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"time":"2020-01-02T00:00:02Z","width_m":3,"work_state":1},"geometry":{"type":"Point","coordinates":[10.5,52.26]}},
    {"type":"Feature","properties":{"time":"2020-01-02T00:00:01Z","width_m":3,"work_state":0},"geometry":{"type":"Point","coordinates":[10.5,52.25,80]}},
    {"type":"Feature","properties":{"time":"2020-01-02T00:00:03Z"},"geometry":null}]})";
  const WorkLog log = read_log(write("p.geojson", points));
  ASSERT_EQ(log.fixes.size(), 2U);
  // Sorted by time.
  EXPECT_EQ(log.fixes[0].position, (Point{10.5, 52.25}));
  EXPECT_EQ(log.fixes[0].record, 2U);
  EXPECT_DOUBLE_EQ(log.fixes[0].time_s, 18263 * 86400.0 + 1);
  EXPECT_EQ(log.fixes[0].work, WorkState::kOff);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOn);
  EXPECT_EQ(log.booms, (std::vector<Boom>{{{1.5, -1.5}}}));
  EXPECT_EQ(log.skipped.count, 1U);
}

TEST_F(ReadLog, PointsOfAGeoPackageInAGrid) {
  testing_files::write_layer("GPKG", path("p.gpkg"), "fixes", 32632,
                             {{"a", "POINT (500000 0)"}, {"b", "POINT (500000 10)"}});
  testing_files::write_layer("GPKG", path("p.gpkg"), "more", 32632, {{"a", "POINT (500000 20)"}}, true);
  EXPECT_TRUE(mentions(refusal(path("p.gpkg")), "fixes (Point), more (Point)"));
  const WorkLog log = read_log(path("p.gpkg"), {"", "", "fixes"});
  ASSERT_EQ(log.fixes.size(), 2U);
  EXPECT_EQ(log.positions, Positions::kLonLat);
  EXPECT_NEAR(log.fixes[0].position.x, 9, 1e-9);
  EXPECT_NEAR(log.fixes[1].position.y, 10 / 110574.3 / 0.9996, 1e-9);
  EXPECT_TRUE(mentions(refusal(path("p.gpkg"), {"", "", "less"}), "no layer 'less'"));
}

TEST_F(ReadLog, FieldsAndLinesAreNoLog) {
  testing_files::write_layer("GPKG", path("f.gpkg"), "fields", 4326, {{"a", "POLYGON ((0 0,1 0,1 1,0 0))"}});
  EXPECT_TRUE(mentions(refusal(path("f.gpkg")), "fields rather than like work"));
  testing_files::write_layer("GPKG", path("l.gpkg"), "lines", 4326, {{"a", "LINESTRING (0 0,1 0)"}});
  EXPECT_TRUE(mentions(refusal(path("l.gpkg")), "no layer with points or polygons"));
}

TEST_F(ReadLog, OtherFilesAreOneLog) {
  const auto logs = list_logs(write("a.csv", kCsv));
  ASSERT_EQ(logs.size(), 1U);
  EXPECT_EQ(logs[0].name, "");
}

}  // namespace tramline::read_log_test
