// Which plans are the same, and which others are made from.

#include "tramline/planner/whole/compared_plans.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tramline/planner/whole/expected_route.h"

namespace tramline {
namespace {

/// Three tracks side by side, from south to north.
ComparedPlan three_tracks(double floor, std::optional<double> price) {
  ComparedPlan out;
  for (int i = 0; i < 3; ++i) {
    TrackPiece piece;
    piece.start = {6.0 * i, 0};
    piece.end = {6.0 * i, 100};
    out.laid.trial.draft.plan.pieces.push_back(piece);
  }
  out.floor = floor;
  out.price = price;
  return out;
}

std::vector<TrackPiece>& pieces_of(ComparedPlan& plan) { return plan.laid.trial.draft.plan.pieces; }

TEST(SameTracksPriced, AreThoseInAnyOrderAndDirectionButForCentimetres) {
  const ComparedPlans plans{three_tracks(90, {}), three_tracks(100, 120)};
  ComparedPlan other = three_tracks(100.005, {});
  std::reverse(pieces_of(other).begin(), pieces_of(other).end());
  std::swap(pieces_of(other).front().start, pieces_of(other).front().end);
  pieces_of(other).back().end.x += 0.04;
  EXPECT_EQ(same_tracks_priced(plans, other), 1U);
}

TEST(SameTracksPriced, AreNoOthers) {
  const ComparedPlans plans{three_tracks(100, {}), three_tracks(100, 120)};
  ComparedPlan moved = three_tracks(100, {}), fewer = three_tracks(100, {}),
               dearer = three_tracks(100.05, {}), behind = three_tracks(100, {});
  pieces_of(moved).front().start.x += 0.2;
  pieces_of(fewer).pop_back();
  behind.laid.trial.draft.plan.headland.passes.resize(1);
  for (const ComparedPlan* other : {&moved, &fewer, &dearer, &behind})
    EXPECT_EQ(same_tracks_priced(plans, *other), std::nullopt);
  EXPECT_EQ(same_tracks_priced({three_tracks(100, {})}, three_tracks(100, {})), std::nullopt)
      << "what has no route yet has no price to tell";
}

// Within a tenth of the least price; those only told of are left where they are.
TEST(NearTheBest, AreTheCheapestOfEachDirectionButThoseToldOf) {
  const auto plan = [](double degrees, double price) {
    ComparedPlan out = three_tracks(0, price);
    out.laid.trial.draft.plan.subfields = {{{}, Direction::clockwise_from_north(Angle::degrees(degrees))}};
    return out;
  };
  ComparedPlans plans{plan(0, 100), plan(0, 104), plan(40, 108), plan(80, 101), plan(120, 130)};
  plans[3].only_told_of = true;
  EXPECT_EQ(near_the_best(plans, 100), (std::vector<std::size_t>{2, 0}));
}

/// A plan behind as many passes all round, with legs without room.
ComparedPlan without_room(int passes, std::size_t legs, std::optional<double> price) {
  ComparedPlan out = three_tracks(0, price);
  out.laid.trial.passes.edges = {passes, passes, passes};
  Plan& plan = out.laid.trial.draft.plan;
  plan.machine.width_m = 3;
  for (std::size_t i = 0; i < legs; ++i) {
    RouteLeg leg;
    leg.kind = LegKind::kTurn;
    leg.missing_m = 2;
    plan.route.legs.push_back(leg);
  }
  return out;
}

// Three plans behind two passes leave the land, by two legs at the least, of 50 € each.
TEST(RoomLackedByOthers, IsTheLeastOfSeveralBehindAsManyPasses) {
  ComparedPlans plans{without_room(2, 3, 400), without_room(2, 2, 300), without_room(1, 1, 250)};
  const ComparedPlan asked = without_room(2, 0, {});
  EXPECT_EQ(room_lacked_by_others(plans, asked), 0) << "two are too few to tell";
  plans.push_back(without_room(2, 4, 500));
  EXPECT_DOUBLE_EQ(room_lacked_by_others(plans, asked), 2 * kPriceWithoutRoom);
  plans[1].only_told_of = true;
  EXPECT_EQ(room_lacked_by_others(plans, asked), 0);
  plans.push_back(without_room(2, 3, 350));
  EXPECT_DOUBLE_EQ(room_lacked_by_others(plans, asked), 3 * kPriceWithoutRoom);
  EXPECT_EQ(room_lacked_by_others(plans, without_room(1, 0, {})), 0);
}

// Three of those within a twentieth of the best, the cheapest first, and none in adjacent order.
TEST(WorthOrderingLonger, AreTheCheapestFew) {
  ComparedPlans plans(7);
  for (const std::size_t i : {0U, 1U, 2U, 3U, 4U, 5U}) plans[i].price = 104.0 - static_cast<double>(i);
  plans[5].laid.kind = Alternative::kAdjacent;
  plans[3].only_told_of = true;
  EXPECT_EQ(worth_ordering_longer(plans, 99), (std::vector<std::size_t>{4, 2, 1}));
  plans[2].price = 104;  // more than 103.95
  plans[1].price = 104;
  EXPECT_EQ(worth_ordering_longer(plans, 99), (std::vector<std::size_t>{4}));
}

ComparedPlan behind(int passes, double direction_deg, std::size_t pieces,
                    std::optional<double> beyond_floor) {
  ComparedPlan out;
  out.laid.trial.passes.edges.assign(4, passes);
  out.laid.trial.draft.plan.subfields.push_back(
      {{}, Direction::clockwise_from_north(Angle::degrees(direction_deg))});
  pieces_of(out).resize(pieces);
  out.beyond_floor = beyond_floor;
  return out;
}

// Other subfields in the same directions may have a lower floor: they are not known by one that costs more.
TEST(HasSuchAsCheap, AsksForPassesDirectionsAndFloor) {
  const auto with_floor = [](double floor, int passes, double direction_deg) {
    ComparedPlan out = behind(passes, direction_deg, 3, {});
    out.floor = floor;
    return out;
  };
  const ComparedPlans plans{with_floor(180, 2, 94)};
  EXPECT_TRUE(has_such_as_cheap(plans, with_floor(180, 2, 94)));
  EXPECT_TRUE(has_such_as_cheap(plans, with_floor(181, 2, 94.5)));
  EXPECT_TRUE(has_such_as_cheap(plans, with_floor(179.99, 2, 94))) << "about the same tracks";
  EXPECT_FALSE(has_such_as_cheap(plans, with_floor(170, 2, 94)));
  EXPECT_FALSE(has_such_as_cheap(plans, with_floor(181, 1, 94)));
  EXPECT_FALSE(has_such_as_cheap(plans, with_floor(181, 2, 97)));
}

// Two fifths of 20 €; behind two passes, three tracks and what counts as two more cost 50 €, so eight and two
// in about the same direction cost three fifths of 100 €.
// Of plans with no more than eleven tracks two fifths of either are expected.
TEST(LeastBeyondFloor, GrowsWithTheTracksOfPlansInTheSameDirectionBehindTheSamePasses) {
  ComparedPlans plans;
  EXPECT_EQ(least_beyond_floor(plans, behind(2, 90, 8, {})), 0);
  plans = {behind(2, 89, 3, 50), behind(1, 90, 3, 20), behind(2, 90, 30, {})};
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, behind(2, 90, 8, {})), 0.4 * 60);
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, behind(2, 90, 12, {})), 0.6 * 14 * 10);
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, behind(2, 93, 8, {})), 0.4 * 8);
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, behind(3, 90, 8, {})), 0.4 * 8);
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, behind(2, 90, 33, {})), 8) << "of many tracks it tells nothing";
  ComparedPlan curved = behind(2, 90, 8, {});
  curved.laid.trial.draft.plan.subfields.front().reference.push_back({{0, 0}, {100, 0}, 0.001});
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, curved), 0.4 * 8);
}

// Two grids cost 10 € and 12 € for each track and what counts as two more: 18 and two cost at least 170 €.
// Two fifths of the 140 € of one are expected in any case, and of few tracks two fifths of that.
TEST(LeastBeyondFloor, IsKnownOfMovedGridsAsSoonAsTwoHaveTheirRoutes) {
  const auto moved = [](int passes, double direction_deg, std::size_t pieces,
                        std::optional<double> beyond_floor) {
    ComparedPlan out = behind(passes, direction_deg, pieces, beyond_floor);
    out.laid.kind = Alternative::kMovedLines;
    return out;
  };
  ComparedPlans plans{moved(2, 0, 12, 140)};
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, moved(2, 60, 18, {})), 0.4 * 140) << "one is not enough";
  plans.push_back(moved(2, 30, 10, 144));
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, moved(2, 60, 18, {})), 0.85 * 20 * 10);
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, moved(3, 60, 18, {})), 0.4 * 140) << "other passes";
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, behind(2, 60, 18, {})), 0.4 * 140) << "not moved";
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, moved(2, 60, 33, {})), 0.4 * 140) << "many tracks";
  EXPECT_DOUBLE_EQ(least_beyond_floor(plans, moved(2, 60, 11, {})), 0.4 * 0.4 * 140) << "few tracks";
}

}  // namespace
}  // namespace tramline
