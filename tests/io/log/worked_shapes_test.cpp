// As-applied polygons, compressed vector files, words for work states and units in names of columns.

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

#include "io/vector/files.h"
#include "support/refusals.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/log/csv_log.h"
#include "tramline/io/log/read_log.h"
#include "tramline/io/log/work_word.h"

namespace tramline::worked_shapes_test {

using namespace io;
using testing_support::mentions;
using testing_support::refusal_of;

class WorkedShapes : public testing_files::Files {
 protected:
  static std::string feature(const std::string& properties, const std::string& geometry) {
    return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":)" + geometry + "}";
  }
  static std::string square(const std::string& lon, const std::string& next) {
    return R"({"type":"Polygon","coordinates":[[[)" + lon + ",52],[" + next + ",52],[" + next +
           ",52.0001],[" + lon + ",52.0001],[" + lon + ",52]]]}";
  }
  static std::string collection(const std::vector<std::string>& features) {
    std::string out = R"({"type":"FeatureCollection","features":[)";
    for (std::size_t i = 0; i < features.size(); ++i) out += (i > 0 ? "," : "") + features[i];
    return out + "]}";
  }
};

TEST_F(WorkedShapes, PolygonsWithRatesAreWorkedGround) {
  const std::string text =
      collection({feature(R"("Time":20,"rate_kg_ha":150)", square("10.0001", "10.0002")),
                  feature(R"("Time":10,"rate_kg_ha":0)", square("10", "10.0001")),
                  feature(R"("Time":30,"rate_kg_ha":120)", R"({"type":"Point","coordinates":[10,52]})")});
  const WorkLog log = read_log(write("applied.geojson", text));
  ASSERT_EQ(log.fixes.size(), 2U);
  ASSERT_EQ(log.shapes.size(), 2U);
  // Put in order of time; a rate of nothing worked nothing.
  EXPECT_EQ(log.fixes[0].record, 2U);
  EXPECT_EQ(log.fixes[0].work, WorkState::kOff);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOn);
  EXPECT_DOUBLE_EQ(log.fixes[1].rate_per_ha, 150);
  const Polygon& shape = log.shapes[static_cast<std::size_t>(log.fixes[1].shape)];
  EXPECT_EQ(shape.outer.size(), 4U);
  EXPECT_GT(signed_area(shape.outer), 0);
  EXPECT_NEAR(log.fixes[1].position.x, 10.00015, 1e-9);
  ASSERT_EQ(log.skipped.count, 1U);
  EXPECT_EQ(log.skipped.listed[0].record, 3U);

  const gzFile file = gzopen(path("applied.geojson.gz").c_str(), "wb9");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  EXPECT_EQ(read_log(path("applied.geojson.gz")).shapes, log.shapes);
}

TEST_F(WorkedShapes, PartsOfOneFeatureAreGroundEach) {
  const std::string parts =
      R"({"type":"MultiPolygon","coordinates":[[[[10,52],[10.001,52],[10.001,52.001],[10,52]]],)"
      R"([[[10.1,52],[10.101,52],[10.101,52.001],[10.1,52]]]]})";
  const WorkLog log = read_log(write("parts.geojson", collection({feature(R"("width_m":6)", parts)})));
  ASSERT_EQ(log.fixes.size(), 2U);
  EXPECT_EQ(log.fixes[0].record, log.fixes[1].record);
  EXPECT_NE(log.fixes[0].shape, log.fixes[1].shape);
}

TEST_F(WorkedShapes, PolygonsThatSayNothingOfWorkAreFields) {
  const std::string file =
      write("field.geojson", collection({feature(R"("name":"home")", square("10", "10.01"))}));
  const std::string sentence = refusal_of([&] { read_log(file); });
  EXPECT_TRUE(mentions(sentence, "fields rather than like work")) << sentence;
}

TEST_F(WorkedShapes, ShapesAreProjected) {
  const std::string text =
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:25832"}},)"
      R"("features":[)" +
      feature(R"("rate":3)", R"({"type":"Polygon","coordinates":[[[500000,5761038],)"
                             R"([500010,5761038],[500010,5761048],[500000,5761038]]]})") +
      "]}";
  const WorkLog log = read_log(write("utm.geojson", text));
  ASSERT_EQ(log.shapes.size(), 1U);
  // The central meridian of zone 32.
  EXPECT_NEAR(log.shapes[0].outer[0].x, 9, 1e-9);
  EXPECT_NEAR(log.shapes[0].outer[0].y, 52, 1e-3);
}

TEST(WorkWord, WordsOfImplements) {
  for (const char* on : {"1", "On", " IN ", "down", "Lowered", "engaged", "TRUE", "yes"})
    EXPECT_EQ(work_word(on), WorkState::kOn) << on;
  for (const char* off : {"0", "off", "Out", "UP", "raised", "disengaged", "false", "No"})
    EXPECT_EQ(work_word(off), WorkState::kOff) << off;
  EXPECT_EQ(work_word(""), WorkState::kUnknown);
  for (const char* none : {"2", "inside", "upper", "-"}) EXPECT_FALSE(work_word(none).has_value()) << none;
}

WorkLog table(const std::string& text) {
  TextLines lines(text);
  return read_csv_log(lines, "", "", "'t.csv'");
}

double width_m(const WorkLog& log) { return log.booms.at(0).at(0).left_m - log.booms.at(0).at(0).right_m; }

TEST(ColumnUnits, WidthsInInchesAndFeet) {
  EXPECT_NEAR(width_m(table("lon,lat,swath_raw_in\n10,52,360\n")), 9.144, 1e-12);
  EXPECT_NEAR(width_m(table("lon,lat,Swath Width (ft)\n10,52,30\n")), 9.144, 1e-12);
  EXPECT_NEAR(width_m(table("lon,lat,working_width_inches\n10,52,360\n")), 9.144, 1e-12);
  EXPECT_NEAR(width_m(table("lon,lat,SWATHWIDTH_CM\n10,52,914.4\n")), 9.144, 1e-12);
  // A name without a unit stands before one with it, and nothing else is a unit.
  EXPECT_NEAR(width_m(table("lon,lat,width_in,width_m\n10,52,360,5\n")), 5, 1e-12);
  EXPECT_TRUE(table("lon,lat,swath_raw_bags\n10,52,360\n").booms.empty());
}

TEST(ColumnUnits, InAndOutAreWorkStates) {
  const WorkLog log = table("lon,lat,Implement Status\n10,52,In\n10,52,Out\n10,52,?\n");
  EXPECT_EQ(log.fixes[0].work, WorkState::kOn);
  EXPECT_EQ(log.fixes[1].work, WorkState::kOff);
  EXPECT_EQ(log.fixes[2].work, WorkState::kUnknown);
}

TEST(ColumnUnits, CountersOfTables) {
  const WorkLog log =
      table("lon,lat,machine,device_area_m2\n10,52,a,100\n10,52,b,7\n10,52,a,160\n10,52,b,9\n");
  EXPECT_DOUBLE_EQ(log.counters.area_m2, 62);
  // 2 acres are 8,093.7 m²; an area that never grows is that of the field.
  EXPECT_NEAR(table("lon,lat,total_area_ac\n10,52,1\n10,52,3\n").counters.area_m2, 8093.7128448, 1e-6);
  EXPECT_FALSE(table("lon,lat,total_area_ha\n10,52,5\n10,52,5\n").counters.any());
}

}  // namespace tramline::worked_shapes_test
