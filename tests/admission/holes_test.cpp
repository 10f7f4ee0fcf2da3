// Holes against one another and against the outer ring. The outer ring is 100 m x 50 m: 5000 m².

#include <gtest/gtest.h>

#include "admission/feature.h"

namespace tramline::testing_features {
namespace {

const std::string kOuter = "0 0, 100 0, 100 50, 0 50, 0 0";

struct Expected {
  std::vector<std::string> holes;  ///< clockwise, so that winding is no fault
  std::size_t obstacles;
  double workable_m2;
  std::size_t repairs;
  double change_m2;
  std::string where;
};

class Holes : public testing::TestWithParam<Expected> {};

TEST_P(Holes, AreSortedAndTheAreaIsAccountedFor) {
  const Expected& expected = GetParam();
  std::vector<std::string> rings = {kOuter};
  rings.insert(rings.end(), expected.holes.begin(), expected.holes.end());
  const Field field = admit_one(rings);
  EXPECT_NEAR(signed_area(field.outer), 5000, 1e-9);
  EXPECT_EQ(field.obstacles.size(), expected.obstacles);
  EXPECT_NEAR(workable_m2(field), expected.workable_m2, 1e-3);
  ASSERT_EQ(field.repairs.size(), expected.repairs);
  EXPECT_NEAR(changes_m2(field), expected.change_m2, 1e-3);
  EXPECT_NEAR(drawn_m2(feature({rings})) + changes_m2(field), workable_m2(field), 1e-3);
  if (expected.repairs > 0) {
    EXPECT_EQ(field.repairs.back().where, expected.where);
  }
}

INSTANTIATE_TEST_SUITE_P(
    EachFault, Holes,
    testing::Values(
        // Two apart.
        Expected{
            {"10 10, 10 20, 20 20, 20 10, 10 10", "40 10, 40 20, 50 20, 50 10, 40 10"}, 2, 4800, 0, 0, ""},
        // Overlapping by 5 x 10: 150 m² of obstacle.
        Expected{{"10 10, 10 20, 20 20, 20 10, 10 10", "15 10, 15 20, 25 20, 25 10, 15 10"},
                 1,
                 4850,
                 1,
                 50,
                 "hole 2"},
        // Sharing an edge: no land is shared, both stay.
        Expected{
            {"10 10, 10 20, 20 20, 20 10, 10 10", "20 10, 20 20, 30 20, 30 10, 20 10"}, 2, 4800, 0, 0, ""},
        // The same hole twice.
        Expected{{"10 10, 10 20, 20 20, 20 10, 10 10", "10 10, 10 20, 20 20, 20 10, 10 10"},
                 1,
                 4900,
                 1,
                 100,
                 "hole 2"},
        // A hole of 4 m² in a hole.
        Expected{{"10 10, 10 20, 20 20, 20 10, 10 10", "14 14, 14 16, 16 16, 16 14, 14 14"},
                 1,
                 4900,
                 1,
                 4,
                 "hole 2"},
        // The same with the inner one first.
        Expected{{"14 14, 14 16, 16 16, 16 14, 14 14", "10 10, 10 20, 20 20, 20 10, 10 10"},
                 1,
                 4900,
                 1,
                 4,
                 "hole 2"},
        // Outside: 100 m² had been subtracted for nothing.
        Expected{{"110 10, 110 20, 120 20, 120 10, 110 10"}, 0, 5000, 1, 100, "hole 1"},
        // Half outside through the east edge.
        Expected{{"95 10, 95 20, 105 20, 105 10, 95 10"}, 1, 4950, 1, 50, "hole 1"},
        // Across the whole field: 10 x 70 drawn, 10 x 50 inside.
        Expected{{"40 -10, 40 60, 50 60, 50 -10, 40 -10"}, 1, 4500, 1, 200, "hole 1"},
        // Sharing 10 m of the east edge.
        Expected{{"90 10, 90 20, 100 20, 100 10, 90 10"}, 1, 4900, 1, 0, "hole 1"},
        // Fewer than three places: no land.
        Expected{{"10 10, 20 20, 10 10"}, 0, 5000, 1, 0, "hole 1"},
        // A comb of two holes that a third connects: 100 + 100 + 30 x 5 less 2 x 50 shared.
        Expected{{"10 10, 10 20, 20 20, 20 10, 10 10", "30 10, 30 20, 40 20, 40 10, 30 10",
                  "10 15, 10 20, 40 20, 40 15, 10 15"},
                 1,
                 4750,
                 2,
                 100,
                 "hole 1 + hole 3"}));

TEST(HolesAtTheEdge, TouchingInOnePointIsLawfulAndOnlyRemarkedOn) {
  // A triangle whose tip lies on the south edge.
  const Field field = admit_one({kOuter, "50 0, 45 10, 55 10, 50 0"});
  EXPECT_TRUE(field.repairs.empty());
  ASSERT_EQ(field.warnings.size(), 1u);
  EXPECT_EQ(field.warnings[0], "hole 1 touches the outer ring");
  EXPECT_NEAR(workable_m2(field), 4950, 1e-9);
}

TEST(HolesAtTheEdge, TheOuterRingIsNotCutByAHoleAtTheEdge) {
  const Field field = admit_one({kOuter, "95 10, 95 20, 105 20, 105 10, 95 10"});
  EXPECT_EQ(field.outer, (Ring{{-50, -25}, {50, -25}, {50, 25}, {-50, 25}}));
  EXPECT_EQ(field.obstacles[0].origin, "hole 1");
  EXPECT_EQ(bounds(field.obstacles[0].shape).max_x, 50);
}

TEST(HolesAtTheEdge, HolesThatCoverTheFieldAreRefused) {
  const std::string sentence = refusal_plain({kOuter, "-1 -1, -1 51, 101 51, 101 -1, -1 -1"});
  EXPECT_NE(sentence.find("its holes cover it completely"), std::string::npos) << sentence;
}

TEST(HolesOfLobes, EachLobeTakesItsOwn) {
  // A bow tie with a hole of 4 m² in each lobe (left lobe round (20, 50), right lobe round (80, 50)).
  const Admission admission =
      admit_plain(feature({{"0 0, 100 100, 100 0, 0 100, 0 0", "19 49, 19 51, 21 51, 21 49, 19 49",
                            "79 49, 79 51, 81 51, 81 49, 79 49"}}));
  ASSERT_EQ(admission.fields.size(), 2u);
  for (const Field& field : admission.fields) {
    expect_admissible(field);
    ASSERT_EQ(field.obstacles.size(), 1u);
    EXPECT_NEAR(workable_m2(field), 2496, 1e-6);
  }
}

}  // namespace
}  // namespace tramline::testing_features
