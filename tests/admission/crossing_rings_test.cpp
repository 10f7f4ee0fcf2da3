// Rings that touch or cross themselves.

#include <gtest/gtest.h>

#include "admission/feature.h"
#include "tramline/admission/disputed_land.h"
#include "tramline/geometry/polygon/interior_point.h"

namespace tramline::testing_features {
namespace {

TEST(CrossingRings, ABowTieGivesTwoFieldsOfItsLobes) {
  // Crossing at (50, 50); each lobe is a triangle of base 100 and height 50: 2500 m². Shoelace area: 0.
  const Admission admission = admit_plain(feature({{"0 0, 100 100, 100 0, 0 100, 0 0"}}));
  ASSERT_EQ(admission.fields.size(), 2u);
  for (const Field& field : admission.fields) {
    expect_admissible(field);
    EXPECT_NEAR(signed_area(field.outer), 2500, 1e-6);
  }
  EXPECT_EQ(admission.fields[0].id, "parcels:7");
  EXPECT_EQ(admission.fields[1].id, "parcels:7#2");
  EXPECT_EQ(admission.fields[1].source.part, 1);
  ASSERT_EQ(admission.fields[0].repairs.size(), 1u);
  EXPECT_NEAR(admission.fields[0].repairs[0].at.x, 50, 1e-9);
  EXPECT_NEAR(admission.fields[0].repairs[0].at.y, 50, 1e-9);
  EXPECT_NEAR(admission.fields[0].repairs[0].area_change_m2, 5000, 1e-6);
  EXPECT_EQ(admission.fields[1].warnings.size(), 1u);
}

TEST(CrossingRings, ASmallLobeIsCutOffAndSaidSo) {
  // Before the corner at (100, 0) the ring runs out below the line y = 0: a triangle (98, 0), (100, -0.5),
  // (100, 0) traversed the other way round: 0.5 m². It crosses at (98, 0).
  const RawFeature raw = feature({{"0 0, 100 0, 100 -0.5, 96 0.5, 96 50, 0 50, 0 0"}});
  const Admission admission = admit_plain(raw);
  ASSERT_EQ(admission.fields.size(), 1u);
  const Field& field = admission.fields.front();
  expect_admissible(field);
  EXPECT_EQ(field.repairs.size(), 2u);
  EXPECT_NEAR(field.repairs[1].area_change_m2, -0.5, 1e-9);
  EXPECT_NEAR(drawn_m2(raw) + changes_m2(field), workable_m2(field), 1e-6);
  // The large lobe: 96 x 50 and the triangle (96, 0), (98, 0), (96, 0.5).
  EXPECT_NEAR(workable_m2(field), 4800 + 0.5, 1e-6);
}

TEST(CrossingRings, ARingThatTouchesItselfEnclosesAHole) {
  // From the middle of the south edge round a diamond of 20 m diagonals (200 m²) and on.
  const RawFeature raw = feature({{"0 0, 50 0, 40 10, 50 20, 60 10, 50 0, 100 0, 100 50, 0 50, 0 0"}});
  const Field field = admit_plain(raw).fields.front();
  expect_admissible(field);
  EXPECT_NEAR(signed_area(field.outer), 5000, 1e-9);
  ASSERT_EQ(field.obstacles.size(), 1u);
  EXPECT_EQ(field.obstacles[0].origin, "hole 1 (enclosed by the outer ring)");
  EXPECT_NEAR(area(field.obstacles[0].shape), 200, 1e-9);
  ASSERT_EQ(field.repairs.size(), 1u);
  EXPECT_EQ(field.repairs[0].at, (Point{50, 0}));
  EXPECT_NEAR(field.repairs[0].area_change_m2, 0, 1e-9);
}

TEST(CrossingRings, LandGoneRoundTwiceIsRefusedWithItsPlace) {
  // The ring goes round a 40 m square with a second loop of 20 m square inside it: winding number 2 there.
  const std::string sentence =
      refusal_plain({"0 0, 40 0, 40 40, 0 40, 0 0, 10 10, 30 10, 30 30, 10 30, 10 10, 0 0"});
  EXPECT_NE(sentence.find("farm.gpkg, feature 'parcels:7': the outer ring goes round 400.0 m²"),
            std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("(20.00, 20.00)"), std::string::npos) << sentence;
}

TEST(CrossingRings, AHoleThatCrossesItselfKeepsItsLobesOut) {
  // The hole is a bow tie with two lobes of 25 m² each.
  const RawFeature raw = feature({{"0 0, 100 0, 100 50, 0 50, 0 0", "10 10, 20 20, 20 10, 10 20, 10 10"}});
  const Field field = admit_plain(raw).fields.front();
  expect_admissible(field);
  ASSERT_EQ(field.obstacles.size(), 2u);
  EXPECT_EQ(field.obstacles[1].origin, "hole 1");
  EXPECT_NEAR(workable_m2(field), 4950, 1e-6);
  EXPECT_NEAR(changes_m2(field), -50, 1e-6);
}

TEST(CrossingRings, WindingNumbersCountTurns) {
  const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(winding_number(square, {1, 1}), 1);
  EXPECT_EQ(winding_number(reversed(square), {1, 1}), -1);
  EXPECT_EQ(winding_number(square, {5, 1}), 0);
  Ring twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_EQ(winding_number(twice, {1, 1}), 2);
}

TEST(InteriorPoint, LiesInTheWidestStretchOfAU) {
  // A U of two arms 10 m and 20 m wide; at half height the wider arm is x in [30, 50].
  const Polygon u{{{0, 0}, {50, 0}, {50, 40}, {30, 40}, {30, 5}, {10, 5}, {10, 40}, {0, 40}}, {}};
  const Point p = interior_point(u);
  EXPECT_EQ(p.x, 40);
  EXPECT_TRUE(contains(u, p));
}

}  // namespace
}  // namespace tramline::testing_features
