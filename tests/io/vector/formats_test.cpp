// The same little field written by OGR in every format comes back with the same area.

#include <cmath>

#include "io/vector/files.h"
#include "tramline/admission/admit.h"

namespace tramline::testing_files {
namespace {

double admitted_m2(const RawDataset& dataset) {
  const RawLayer& layer = dataset.layers.front();
  const Crs crs(layer.crs);
  double sum = 0;
  for (const RawFeature& feature : layer.features)
    for (const Field& field : admit(feature, {dataset.file, layer.name, &crs, dataset.winding}).fields) {
      sum += signed_area(field.outer);
      for (const Obstacle& obstacle : field.obstacles) sum -= area(obstacle.shape);
    }
  return sum;
}

// 0.002° x 0.001° on the equator, less a hole of 0.0005° x 0.0004°.
const char* const kDegrees =
    "POLYGON ((30 0, 30.002 0, 30.002 0.001, 30 0.001, 30 0),"
    " (30.0005 0.0002, 30.0005 0.0006, 30.001 0.0006, 30.001 0.0002, 30.0005 0.0002))";
// Metres on the ellipsoid per degree at the equator: a·π/180 east and a(1 − e²)·π/180 north.
const double kExpectedDegrees_m2 = (0.002 * 0.001 - 0.0005 * 0.0004) * 111319.49079 * 110574.27582;

// A 100 m square of UTM grid on the central meridian less a 10 m one: see AreasAreThoseOfTheLandNotOfTheGrid.
const char* const kUtm =
    "POLYGON ((499950 5500000, 500050 5500000, 500050 5500100, 499950 5500100, 499950 5500000),"
    " (499990 5500040, 499990 5500050, 500000 5500050, 500000 5500040, 499990 5500040))";
const double kExpectedUtm_m2 = 9900 / (0.9996 * 0.9996);

struct Format {
  const char* driver;
  const char* file;
  bool only_degrees;
};

class Formats : public Files, public testing::WithParamInterface<Format> {};

TEST_P(Formats, KeepAreaIdAndHole) {
  const Format format = GetParam();
  const std::string file = path(format.file);
  for (const bool degrees : {true, false}) {
    if (!degrees && format.only_degrees) continue;
    std::filesystem::remove_all(file);
    write_layer(format.driver, file, "field", degrees ? 4326 : 25832, {{"north", degrees ? kDegrees : kUtm}});
    const RawDataset dataset = read_vector(query(file));
    ASSERT_EQ(dataset.layers.size(), 1u);
    ASSERT_EQ(dataset.layers[0].features.size(), 1u);
    const RawFeature& feature = dataset.layers[0].features[0];
    EXPECT_EQ(feature.id, "north");
    ASSERT_EQ(feature.polygons.size(), 1u);
    ASSERT_EQ(feature.polygons[0].rings.size(), 2u);
    EXPECT_EQ(feature.polygons[0].rings[0].points.size(), 4u);
    EXPECT_TRUE(feature.polygons[0].rings[0].closed);
    const double expected_m2 = degrees ? kExpectedDegrees_m2 : kExpectedUtm_m2;
    // Text formats round to 7 decimals of a degree (1 cm) at worst.
    EXPECT_NEAR(admitted_m2(dataset), expected_m2, expected_m2 * 1e-6)
        << format.driver << (degrees ? " degrees" : " UTM");
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Formats,
                         testing::Values(Format{"GeoJSON", "f.geojson", true},
                                         Format{"GPKG", "f.gpkg", false},
                                         Format{"ESRI Shapefile", "f.shp", false},
                                         Format{"FlatGeobuf", "f.fgb", false}, Format{"KML", "f.kml", true},
                                         Format{"GML", "f.gml", false}, Format{"SQLite", "f.sqlite", false}),
                         [](const auto& test) {
                           std::string name = test.param.driver;
                           std::erase(name, ' ');
                           return name;
                         });

using GeoPackage = Files;

TEST_F(GeoPackage, ArcsBecomeChordsThatLoseLessThanAHundredthPerCent) {
  // A circular pivot of radius 400 m.
  write_layer("GPKG", path("pivot.gpkg"), "field", 25832,
              {{"pivot", "CURVEPOLYGON (CIRCULARSTRING (500400 5500000, 499600 5500000, 500400 5500000))"}});
  const RawDataset dataset = read_vector(query(path("pivot.gpkg")));
  EXPECT_TRUE(dataset.layers[0].features[0].was_curved);
  const double circle_m2 = M_PI * 400 * 400 / (0.9996 * 0.9996);
  EXPECT_NEAR(admitted_m2(dataset), circle_m2, circle_m2 * 1e-4);
  EXPECT_LT(admitted_m2(dataset), circle_m2);
}

TEST_F(GeoPackage, HeightsAndMeasuresAreNoted) {
  write_layer("GPKG", path("zm.gpkg"), "field", 25832,
              {{"a", "POLYGON ZM ((0 0 5 1, 10 0 5 1, 10 10 5 1, 0 0 5 1))"}});
  const RawFeature feature = read_vector(query(path("zm.gpkg"))).layers[0].features[0];
  EXPECT_TRUE(feature.had_z);
  EXPECT_TRUE(feature.had_m);
}

TEST_F(GeoPackage, WithoutACrsIsWithoutACrs) {
  write_layer("GPKG", path("plain.gpkg"), "field", 0, {{"a", "POLYGON ((0 0, 100 0, 100 50, 0 50, 0 0))"}});
  EXPECT_EQ(read_vector(query(path("plain.gpkg"))).layers[0].crs, "");
}

TEST_F(GeoPackage, TheOneLayerWithPolygonsIsTakenAndTheOthersListed) {
  write_layer("GPKG", path("two.gpkg"), "roads", 25832, {{"r", "LINESTRING (0 0, 1 1)"}});
  write_layer("GPKG", path("two.gpkg"), "fields", 25832, {{"f", "POLYGON ((0 0, 100 0, 100 50, 0 0))"}},
              true);
  const RawDataset dataset = read_vector(query(path("two.gpkg")));
  ASSERT_EQ(dataset.layers.size(), 1u);
  EXPECT_EQ(dataset.layers[0].name, "fields");
  ASSERT_EQ(dataset.skipped.size(), 1u);
  EXPECT_EQ(dataset.skipped[0].what, "layer roads (Line String)");
  VectorQuery everything = query(path("two.gpkg"));
  everything.all_layers = true;
  EXPECT_EQ(read_vector(everything).layers.size(), 2u);
}

TEST_F(GeoPackage, ALayerThatIsOnlyAHintMayBeMissing) {
  write_layer("GPKG", path("f.gpkg"), "fields", 25832, {{"a", "POLYGON ((0 0, 100 0, 100 50, 0 0))"}});
  VectorQuery hinted = query(path("f.gpkg"), "renamed");
  hinted.layer_is_hint = true;
  EXPECT_EQ(read_vector(hinted).layers[0].name, "fields");
}

TEST_F(GeoPackage, FiltersNumbersAndLimits) {
  const std::string square = "POLYGON ((0 0, 100 0, 100 50, 0 0))";
  write_layer("GPKG", path("f.gpkg"), "fields", 25832, {{"a", square}, {"b", square}, {"c", square}});
  const RawDataset filtered = read_vector(query(path("f.gpkg"), "", "id = 'b'"));
  ASSERT_EQ(filtered.layers[0].features.size(), 1u);
  EXPECT_EQ(filtered.layers[0].features[0].id, "b");
  VectorQuery by_number = query(path("f.gpkg"), "fields");
  by_number.fid = 3;
  EXPECT_EQ(read_vector(by_number).layers[0].features.at(0).id, "c");
  VectorQuery limited = query(path("f.gpkg"));
  limited.limit = 2;
  EXPECT_EQ(read_vector(limited).layers[0].features.size(), 2u);
  EXPECT_EQ(read_vector(limited).layers[0].matching, 3);
}

}  // namespace
}  // namespace tramline::testing_files
