// Faults of single rings that change no area.

#include <gtest/gtest.h>

#include "admission/feature.h"

namespace tramline::testing_features {
namespace {

TEST(Rings, ASoundFieldHasNoRepairs) {
  const Field field = admit_one({"1000 1000, 1100 1000, 1100 1050, 1000 1050, 1000 1000"});
  EXPECT_TRUE(field.repairs.empty());
  EXPECT_TRUE(field.warnings.empty());
  EXPECT_EQ(field.id, "parcels:7");
  EXPECT_EQ(field.source.fid, 7);
  // The box is centred on (1050, 1025).
  EXPECT_EQ(field.outer, (Ring{{-50, -25}, {50, -25}, {50, 25}, {-50, 25}}));
}

TEST(Rings, AnUnclosedRingIsClosedAtItsLastVertex) {
  const Field field = admit_one({"1000 1000, 1100 1000, 1100 1050, 1000 1050"});
  ASSERT_EQ(field.repairs.size(), 1u);
  EXPECT_EQ(field.repairs[0].where, "outer ring, vertex 4");
  EXPECT_EQ(field.repairs[0].at, (Point{1000, 1050}));
  EXPECT_EQ(field.repairs[0].area_change_m2, 0);
  EXPECT_EQ(signed_area(field.outer), 5000);
}

TEST(Rings, DuplicatePointsAreRemovedInPlaceAndRoundTheEnd) {
  const Field field = admit_one({"0 0, 100 0, 100 0, 100 50, 0 50, 0 0, 0 0"});
  ASSERT_EQ(field.repairs.size(), 2u);
  EXPECT_EQ(field.repairs[0].where, "outer ring, vertex 3");
  EXPECT_EQ(field.repairs[0].at, (Point{100, 0}));
  EXPECT_EQ(field.repairs[1].where, "outer ring, vertex 6");
  EXPECT_EQ(field.repairs[1].at, (Point{0, 0}));
  EXPECT_EQ(field.outer.size(), 4u);
}

TEST(Rings, PointsAMicrometreApartAreOnePlaceAndAMillimetreApartAreTwo) {
  EXPECT_EQ(admit_one({"0 0, 100 0, 100 0.0000005, 100 50, 0 50, 0 0"}).outer.size(), 4u);
  EXPECT_EQ(admit_one({"0 0, 100 0, 100 0.001, 100 50, 0 50, 0 0"}).outer.size(), 5u);
}

TEST(Rings, ASpikeWithoutWidthIsRemovedWholeIncludingItsFoot) {
  // Out from (100, 20) to (130, 20) in two steps and back.
  const Field field = admit_one({"0 0, 100 0, 100 20, 120 20, 130 20, 120 20, 100 20, 100 50, 0 50, 0 0"});
  ASSERT_FALSE(field.repairs.empty());
  EXPECT_EQ(field.repairs[0].where, "outer ring, vertex 5");
  EXPECT_EQ(field.repairs[0].at, (Point{130, 20}));
  EXPECT_EQ(signed_area(field.outer), 5000);
  EXPECT_EQ(bounds(field.outer).width(), 100);
  EXPECT_EQ(changes_m2(field), 0);
}

TEST(Rings, ASharpCornerThatIsNoSpikeStays) {
  // A triangle 100 m long and 2 cm wide at its foot: 1 m².
  const Field field = admit_one({"0 0, 100 0.01, 0 0.02, 0 0"});
  EXPECT_TRUE(field.repairs.empty());
  EXPECT_NEAR(signed_area(field.outer), 1, 1e-9);
}

TEST(Rings, WindingIsAFaultOnlyWhereTheFormatPrescribesIt) {
  const RawFeature clockwise = feature({{"0 0, 0 50, 100 50, 100 0, 0 0"}});
  const Field shapefile = admit_plain(clockwise, RingWinding::kFree).fields.front();
  EXPECT_TRUE(shapefile.repairs.empty());
  EXPECT_EQ(signed_area(shapefile.outer), 5000);
  const Field geojson = admit_plain(clockwise, RingWinding::kPrescribed).fields.front();
  ASSERT_EQ(geojson.repairs.size(), 1u);
  EXPECT_EQ(geojson.repairs[0].where, "outer ring");
  EXPECT_EQ(geojson.repairs[0].at, (Point{0, 0}));
  EXPECT_EQ(signed_area(geojson.outer), 5000);
}

TEST(Rings, AHoleThatRunsLikeTheOuterRingIsAFaultInAnyFormat) {
  const Field field = admit_one({"0 0, 100 0, 100 50, 0 50, 0 0", "10 10, 20 10, 20 20, 10 20, 10 10"});
  ASSERT_EQ(field.repairs.size(), 1u);
  EXPECT_EQ(field.repairs[0].where, "hole 1");
  EXPECT_EQ(field.repairs[0].area_change_m2, 0);
  EXPECT_EQ(workable_m2(field), 4900);
}

}  // namespace
}  // namespace tramline::testing_features
