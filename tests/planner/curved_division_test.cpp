#include "tramline/planner/curved/curved_division.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planner/prepared.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/curved/best_curved.h"
#include "tramline/planner/search/merge_pairs.h"

namespace tramline::curved_division_test {

constexpr double kInner_m = 60, kOuter_m = 84;
constexpr int kChords = 60;

/// Between two circles about the origin, from one sixtieth of a quarter to another.
Polygon bend(int from, int to) {
  Polygon out;
  const auto add = [&out](double radius_m, int i) {
    const double turn = 0.5 * std::numbers::pi * i / kChords;
    out.outer.push_back(radius_m * Point{std::cos(turn), std::sin(turn)});
  };
  for (int i = from; i <= to; ++i) add(kOuter_m, i);
  for (int i = to; i >= from; --i) add(kInner_m, i);
  return out;
}

LinedSubfield straight(const Polygon& shape, double degrees) {
  return {{shape, Direction::clockwise_from_north(Angle::degrees(degrees))}, 0};
}

testing::Prepared prepared(const Polygon& shape) {
  Field field;
  field.outer = shape.outer;
  Machine machine;
  machine.width_m = 6;
  return {{field, machine, {}, {}}};
}

// A limit above the cost of the best curve changes nothing. Below it some curves are not completed, and what
// is found costs no less.
TEST(BestCurve, IsTheSameWithALimitThatItKeeps) {
  const testing::Prepared quarter = prepared(bend(0, kChords));
  const auto best = best_curved(quarter.task(), SearchContext(1));
  ASSERT_TRUE(best);
  const double cost = best->candidate.cost();
  ASSERT_GT(cost, 3);
  const auto bounded = best_curved(quarter.task(), SearchContext(1), 1.001 * cost);
  ASSERT_TRUE(bounded);
  EXPECT_EQ(bounded->candidate.cost(), cost);
  const auto beyond = best_curved(quarter.task(), SearchContext(1), 0.5);
  ASSERT_TRUE(beyond);
  EXPECT_GE(beyond->candidate.cost(), cost);
}

// Three parts of a bend 24 m wide become one again, driven in four tracks round it. Their three turns cost 3;
// little is added, since a swath of 6 m between concentric arcs neither overlaps nor misses anything but the
// slivers between the arcs and their chords.
TEST(CurvedDivision, JoinsWhatOneCurveSuits) {
  const testing::Prepared quarter = prepared(bend(0, kChords));
  const std::vector<LinedSubfield> parts{straight(bend(0, 20), 0), straight(bend(20, 40), 135),
                                         straight(bend(40, kChords), 90)};
  for (const OtherSubfields others : {OtherSubfields::kStraight, OtherSubfields::kCurved}) {
    const auto found = best_division_along_curves(quarter.task(), {parts}, others, SearchContext(1));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->subfields.size(), 1U);
    EXPECT_FALSE(found->subfields.front().reference.empty());
    EXPECT_EQ(found->avoided.tally.pieces, 4);
    EXPECT_GT(found->cost(), 3);
    EXPECT_LT(found->cost(), 4.5);
  }
}

// A block beside the bend stays straight where it may, and goes with a curve where all are to.
TEST(CurvedDivision, LeavesStraightWhatNoCurveSuits) {
  const Polygon block{{{60, -102}, {300, -102}, {300, 0}, {60, 0}}, {}}, arm = bend(0, kChords);
  const testing::Prepared both = prepared(*merged_shape(block, arm));
  const std::vector<LinedSubfield> parts{straight(block, 90), straight(arm, 135)};
  const auto mixed =
      best_division_along_curves(both.task(), {parts}, OtherSubfields::kStraight, SearchContext(1));
  ASSERT_TRUE(mixed);
  ASSERT_EQ(mixed->subfields.size(), 2U);
  EXPECT_TRUE(mixed->subfields[0].reference.empty());
  EXPECT_FALSE(mixed->subfields[1].reference.empty());
  const auto curved =
      best_division_along_curves(both.task(), {parts}, OtherSubfields::kCurved, SearchContext(1));
  ASSERT_TRUE(curved);
  for (const Subfield& subfield : curved->subfields) EXPECT_FALSE(subfield.reference.empty());
  EXPECT_LE(mixed->cost(), curved->cost());
}

TEST(CurvedDivision, IsNoneWhereNoEdgeBends) {
  const Polygon left{{{0, 0}, {60, 0}, {60, 90}, {0, 90}}, {}},
      right{{{60, 0}, {120, 0}, {120, 90}, {60, 90}}, {}};
  const testing::Prepared both = prepared(*merged_shape(left, right));
  const std::vector<LinedSubfield> parts{straight(left, 0), straight(right, 90)};
  for (const OtherSubfields others : {OtherSubfields::kStraight, OtherSubfields::kCurved})
    EXPECT_FALSE(best_division_along_curves(both.task(), {parts}, others, SearchContext(1)));
}

/// Numbers stand for subfields: two may be joined to their sum, which saves what the table says.
struct Looked {
  std::vector<IndexPair> asked;
  std::vector<std::optional<MergedPair<int>>> operator()(const std::vector<int>& among,
                                                         const std::vector<IndexPair>& places) {
    std::vector<std::optional<MergedPair<int>>> out;
    for (const IndexPair& pair : places) {
      asked.push_back(pair);
      const int whole = among[pair.first] + among[pair.second];
      const double saving = whole == 3 ? 1 : whole == 6 ? 2 : whole == 7 ? 0 : -1;
      out.push_back(MergedPair<int>{pair, whole, saving});
    }
    return out;
  }
};

// Of 1, 2, 4 and 5 first 1 and 5 (saves 2, more than 1 and 2), then nothing more than 2 + 5 or 4 + 3 would:
// of what is left, 6, 2 and 4, the pair of 2 and 4 saves 2, and 6 with 6 costs more.
TEST(JoinPairs, TakesThePairThatSavesMostAgainAndAgain) {
  Looked looked;
  const std::vector<int> left =
      merge_pairs(std::vector<int>{1, 2, 4, 5},
                  [&looked](const std::vector<int>& among, const std::vector<IndexPair>& places) {
                    return looked(among, places);
                  });
  EXPECT_EQ(left, (std::vector<int>{6, 6}));
  // Six pairs of four, then 6 with 2 and with 4, then 6 with 6.
  EXPECT_EQ(looked.asked.size(), 6U + 2U + 1U);
}

}  // namespace tramline::curved_division_test
