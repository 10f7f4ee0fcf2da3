// Features as a whole: parts, dropped dimensions, zone prefixes, projected areas.

#include <gtest/gtest.h>

#include "admission/feature.h"

namespace tramline::testing_features {
namespace {

TEST(Admit, PartsOfAMultipolygonBecomeFieldsOfTheirOwn) {
  RawFeature raw = feature({{"0 0, 100 0, 100 50, 0 50, 0 0"}, {"200 0, 240 0, 240 50, 200 50, 200 0"}});
  raw.id = "home";
  const Admission admission = admit_plain(raw);
  ASSERT_EQ(admission.fields.size(), 2u);
  EXPECT_EQ(admission.fields[0].id, "home");
  EXPECT_EQ(admission.fields[1].id, "home#2");
  EXPECT_EQ(signed_area(admission.fields[1].outer), 2000);
  EXPECT_EQ(admission.fields[1].frame.origin_x_m, 220);
  EXPECT_EQ(admission.fields[1].source.part, 1);
  EXPECT_EQ(admission.fields[1].source.layer, "parcels");
}

TEST(Admit, APartWithoutAreaIsLeftOutAndListed) {
  const Admission admission = admit_plain(feature({{"0 0, 9 9, 0 0"}, {"0 0, 100 0, 100 50, 0 50, 0 0"}}));
  ASSERT_EQ(admission.fields.size(), 1u);
  ASSERT_EQ(admission.fields[0].repairs.size(), 1u);
  EXPECT_NE(admission.fields[0].repairs[0].what.find("was left out"), std::string::npos);
}

TEST(Admit, HeightsAndMeasuresAreDroppedAndListed) {
  RawFeature raw = feature({{"0 0, 100 0, 100 50, 0 50, 0 0"}});
  raw.had_z = true;
  raw.had_m = true;
  const Field field = admit_plain(raw).fields.front();
  ASSERT_EQ(field.repairs.size(), 2u);
  EXPECT_EQ(field.repairs[0].what, "heights (Z) were left out");
  EXPECT_EQ(field.repairs[1].what, "measures (M) were left out");
}

TEST(Admit, LinesBesideThePolygonsAreSkippedAndListed) {
  RawFeature raw = feature({{"0 0, 100 0, 100 50, 0 50, 0 0"}});
  raw.lines = {{{0, 0}, {1, 1}}};
  ASSERT_EQ(admit_plain(raw).skipped.size(), 1u);
  EXPECT_EQ(admit_plain(raw).skipped[0].what, "1 line(s)");
}

// UTM scales lengths by 0.9996 on the central meridian, so 100 m x 100 m of grid are (100 / 0.9996)² m² of
// land.
TEST(Admit, AreasAreThoseOfTheLandNotOfTheGrid) {
  const Crs utm("EPSG:25832");
  const RawFeature raw =
      feature({{"499950 5500000, 500050 5500000, 500050 5500100, 499950 5500100, 499950 5500000"}});
  const Field field = admit(raw, {"farm.gpkg", "parcels", &utm}).fields.front();
  EXPECT_NEAR(signed_area(field.outer), 10000 / (0.9996 * 0.9996), 0.001);
  EXPECT_NEAR(field.frame.origin_lon_deg, 9, 1e-7);
  EXPECT_TRUE(field.repairs.empty());
}

TEST(Admit, AZonePrefixIsTakenOffAndListedWithTheInputsOwnEasting) {
  const Crs utm("EPSG:25832");
  const AdmissionContext context{"farm.gpkg", "parcels", &utm};
  const RawFeature prefixed =
      feature({{"32499950 5500000, 32500050 5500000, 32500050 5500000, 32500050 5500100, 32499950 5500100, "
                "32499950 5500000"}});
  const Field field = admit(prefixed, context).fields.front();
  EXPECT_NEAR(signed_area(field.outer), 10000 / (0.9996 * 0.9996), 0.001);
  ASSERT_EQ(field.repairs.size(), 2u);
  EXPECT_NE(field.repairs[0].what.find("zone number 32"), std::string::npos);
  EXPECT_EQ(field.repairs[0].at, (Point{32499950, 5500000}));
  // The doubled vertex, too, is named by the easting that stands in the file.
  EXPECT_NEAR(field.repairs[1].at.x, 32500050, 1e-6);
}

TEST(Admit, AFalseEastingWithTheZoneInItIsLawful) {
  const Crs prefixed("EPSG:4647");
  const RawFeature raw =
      feature({{"32499950 5500000, 32500050 5500000, 32500050 5500100, 32499950 5500100, 32499950 5500000"}});
  const Field field = admit(raw, {"farm.gpkg", "parcels", &prefixed}).fields.front();
  EXPECT_TRUE(field.repairs.empty());
  EXPECT_NEAR(signed_area(field.outer), 10000 / (0.9996 * 0.9996), 0.001);
}

}  // namespace
}  // namespace tramline::testing_features
