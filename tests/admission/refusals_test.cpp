// What is refused, and that the sentence says where and what to do.

#include <gtest/gtest.h>

#include "admission/feature.h"

namespace tramline::testing_features {
namespace {

void expect_says(const std::string& sentence, const std::string& part) {
  EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

std::string refusal_in(const std::string& crs_name, const std::vector<std::string>& rings) {
  const Crs crs(crs_name);
  return refusal(feature({rings}), {"farm.gpkg", "parcels", &crs});
}

TEST(Refusals, NotFiniteCoordinatesNameRingAndVertex) {
  const std::string sentence =
      refusal_plain({"0 0, 100 0, 100 50, 0 50, 0 0", "10 10, nan 20, 20 20, 10 10"});
  expect_says(sentence, "farm.gpkg, feature 'parcels:7': hole 1, vertex 2");
  expect_says(refusal_plain({"0 0, inf 0, 100 50, 0 50, 0 0"}), "outer ring, vertex 2");
}

TEST(Refusals, DegreesBeyondTheGlobe) {
  expect_says(refusal_in("EPSG:4326", {"10 89, 11 91, 12 89, 10 89"}),
              "vertex 2 has the latitude 91, beyond 90 degrees");
  expect_says(refusal_in("EPSG:4326", {"10 50, 181 50, 12 51, 10 50"}),
              "vertex 2 has the longitude 181, beyond 180");
  // Metres declared as degrees.
  expect_says(refusal_in("EPSG:4326", {"600000 5800000, 600100 5800000, 600100 5800100, 600000 5800000"}),
              "--crs");
}

TEST(Refusals, DegreesThatCountAsMetres) {
  const std::vector<std::string> degrees = {"10 50, 10.01 50, 10.01 50.01, 10 50"};
  expect_says(refusal_in("none", degrees), "look like degrees but count as plain metres");
  expect_says(refusal_in("none", degrees), "--crs EPSG:4326");
  expect_says(refusal_in("EPSG:25832", degrees), "count as ETRS89 / UTM zone 32N (EPSG:25832)");
  // Plain metres near the origin are not suspected: no field is less than a metre wide.
  const Crs plain;
  const RawFeature metres = feature({{"0 0, 90 0, 90 50, 0 50, 0 0"}});
  EXPECT_EQ(admit(metres, {"farm.gpkg", "parcels", &plain}).fields.size(), 1u);
}

TEST(Refusals, NoArea) {
  expect_says(refusal_plain({"0 0, 100 0, 0 0"}), "fewer than three distinct points");
  expect_says(refusal_plain({"0 0, 0 0, 0 0, 0 0"}), "fewer than three distinct points");
  expect_says(refusal_plain({"0 0, 50 50, 100 100, 0 0"}), "has no area");
}

TEST(Refusals, LinesPointsAndNothing) {
  const Crs plain;
  const AdmissionContext context{"farm.gpkg", "parcels", &plain};
  RawFeature line;
  line.fid = 3;
  line.geometry_type = "Line String";
  line.lines = {{{0, 0}, {10, 0}}};
  expect_says(refusal(line, context), "feature 'parcels:3': the geometry is a Line String, not a polygon");
  RawFeature nothing;
  nothing.id = "x";
  nothing.geometry_type = "none";
  expect_says(refusal(nothing, context), "feature 'x': the feature has no geometry");
}

TEST(Refusals, CoordinatesOutsideTheirCrs) {
  expect_says(refusal_in("EPSG:25832", {"1e9 1e9, 1.1e9 1e9, 1.1e9 1.1e9, 1e9 1e9"}), "--crs");
}

TEST(Refusals, AFieldAsWideAsACountry) {
  expect_says(refusal_in("EPSG:4326", {"5 50, 15 50, 15 51, 5 51, 5 50"}), "km wide");
}

TEST(Refusals, AZonePrefixOfAnotherZone) {
  const std::string sentence =
      refusal_in("EPSG:25832", {"33400000 5800000, 33400100 5800000, 33400100 5800100, 33400000 5800000"});
  expect_says(sentence, "the eastings carry zone 33");
}

}  // namespace
}  // namespace tramline::testing_features
