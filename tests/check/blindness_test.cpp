// A verifier that never finds anything is worth nothing: each fault made on purpose is found, and
// found under the right name only.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "check/plans.h"

namespace tramline {
namespace {

using namespace testing_plans;

TEST(Blindness, SwathMovedIntoAnObstacle) {
  Plan plan = obstacle_plan();
  // From behind the obstacle's edge to 10 cm before its other side.
  for (TrackPiece& piece : plan.pieces)
    if (piece.end.x == 40) {
      piece.end.x = 40.1;
      piece.stop_at_end = true;
    }
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});
}

TEST(Blindness, SwathTwoMillimetresInsideAnObstacle) {
  Plan plan = obstacle_plan();
  for (TrackPiece& piece : plan.pieces)
    if (piece.end.x == 40) piece.end.x = 40.0005;
  EXPECT_EQ(found(settled(plan)), Names{});
  for (TrackPiece& piece : plan.pieces)
    if (piece.end.x == 40.0005) piece.end.x = 40.002;
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});
}

TEST(Blindness, SwathOverAPassableAndOverLandGivenUp) {
  Plan plan = crossing_plan();
  plan.pieces[0].end.x = 40.1;
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});

  plan = given_up_plan();
  for (TrackPiece& piece : plan.pieces)
    if (piece.end.x == 40) piece.end.x = 40.1;
  EXPECT_EQ(found(settled(plan)), Names{"swaths"});
}

TEST(Blindness, SwathBeyondAHardBoundary) {
  Plan plan = triangle_plan(EndRule::kCheapest, cheapest_share(Objective{}));
  plan.settings.boundary = EdgeKind::kHard;
  EXPECT_EQ(found(plan), Names{"swaths"});
  plan = triangle_plan(EndRule::kInside, 1);
  plan.settings.boundary = EdgeKind::kHard;
  EXPECT_EQ(found(plan), Names{});
}

TEST(Blindness, RemovedTrackWithTheOldTally) {
  Plan plan = rectangle_plan();
  plan.pieces.erase(plan.pieces.begin() + 4);
  EXPECT_EQ(found(plan), Names{"tally"});
}

TEST(Blindness, FieldCornerDeleted) {
  Plan plan = rectangle_plan();
  plan.field.outer.erase(plan.field.outer.begin() + 2);
  EXPECT_EQ(found(plan), Names{"body"});
}

TEST(Blindness, LandGivenUpOutsideTheBody) {
  Plan plan = rectangle_plan();
  plan.given_up = {{box(100.01, 0, 101, 10), {}}};
  // Its swaths now stop against that land, were it there.
  plan.given_up[0].outer = box(110, 0, 120, 10);
  EXPECT_EQ(found(plan), Names{"body"});
}

TEST(Blindness, OverlapOfASwathThatIsNotItsOwn) {
  Plan plan = rectangle_plan();
  for (TrackPiece& piece : plan.pieces) piece.overlap_m2 = 0;
  EXPECT_EQ(found(plan), Names{});
  // The first track alone passes the edge, by 2 m: 3 m wide, that is 6 m².
  plan.pieces[0].end.x = 102;
  plan.pieces[0].overlap_m2 = 6;
  plan = settled(plan);
  plan.settings.end_rule = EndRule::kCover;
  const Names beside = found(plan);
  EXPECT_EQ(beside.count("swath overlap"), 0u);
  std::swap(plan.pieces[0].overlap_m2, plan.pieces[1].overlap_m2);
  Names both = beside;
  both.insert("swath overlap");
  EXPECT_EQ(found(plan), both);
}

TEST(Blindness, FalseFigures) {
  const Plan honest = triangle_plan(EndRule::kCentre, 0.5);
  ASSERT_EQ(found(honest), Names{});
  const auto with = [&](auto change) {
    Plan plan = honest;
    change(plan);
    return found(plan);
  };
  EXPECT_EQ(with([](Plan& p) { p.tally.overlap_m2 += 0.01; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.uncovered_m2 -= 0.01; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.worked_m2 += 0.01; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.track_length_m += 0.001; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.turns -= 1; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.stops += 1; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.crossings += 1; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.pieces += 1; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.cost *= 0.999; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.tally.overlap_m2 = std::numeric_limits<double>::quiet_NaN(); }),
            Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.uncovered.clear(); }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.overlap = {{box(-50, -50, -49, -49), {}}}; }), Names{"tally"});
  EXPECT_EQ(with([](Plan& p) { p.overlap = {{box(1, 1, 11, 11), {}}}; }), Names{"tally"});
}

/// Land worked twice within the field, and worked beyond it; by three swaths, too.
TEST(Blindness, LayersOfLandThatAreNotSo) {
  const auto with = [](Plan plan, auto change) {
    plan = settled(plan);
    EXPECT_EQ(found(plan), Names{});
    change(plan);
    return found(plan);
  };
  // 20 triangles of 3 m² along the border, worked from both sides; 20 ends of 5 m² beyond the hypotenuse.
  const Plan twice = two_subfields_plan(), beyond = triangle_plan(EndRule::kCover, 0);
  Plan thrice = rectangle_plan();
  thrice.pieces.push_back(thrice.pieces[4]);
  thrice.pieces.push_back(thrice.pieces[4]);
  ASSERT_NEAR(area(thrice.overlap), 0, 1e-6);
  ASSERT_NEAR(area(settled(thrice).overlap), 300, 1e-6);
  for (const Plan& plan : {twice, beyond, thrice}) {
    EXPECT_EQ(with(plan, [](Plan& p) { p.overlap.clear(); }), Names{"tally"});
    EXPECT_EQ(with(plan, [](Plan& p) { p.overlap.pop_back(); }), Names{"tally"});
    EXPECT_EQ(with(plan, [](Plan& p) { p.overlap.push_back(p.overlap.front()); }), Names{"tally"});
    EXPECT_EQ(with(plan, [](Plan& p) { p.overlap.push_back({box(1, 1, 2, 2), {}}); }), Names{"tally"});
  }
  // As much elsewhere does not do.
  EXPECT_EQ(with(thrice, [](Plan& p) { p.overlap = {{box(0, 3, 100, 6), {}}}; }), Names{"tally"});
  const Plan missed = triangle_plan(EndRule::kInside, 1);
  EXPECT_EQ(with(missed, [](Plan& p) { p.uncovered.pop_back(); }), Names{"tally"});
  EXPECT_EQ(with(missed, [](Plan& p) { p.uncovered.push_back(p.uncovered.front()); }), Names{"tally"});
}

/// A track beside the land, whose swath's side runs along its edge from one end to the other but for a slant.
TEST(Blindness, LandAlongTheSideOfASwath) {
  const auto slanted_by = [](double slant_m) {
    Plan plan = rectangle_plan();  // 30 m high, 3 m wide
    plan.settings.end_rule = EndRule::kCover;
    plan.field.outer = {{0, 0}, {100, 0}, {100, 30 + slant_m}, {0, 30 - slant_m}};
    plan.body = {{plan.field.outer, {}}};
    plan.subfields[0].shape = plan.body[0];
    TrackPiece beside = plan.pieces.back();
    beside.start.y = beside.end.y = 31.5;
    beside.track += 1;
    plan.pieces.push_back(beside);
    return found(settled(plan)).count("ends");
  };
  EXPECT_EQ(slanted_by(4e-7), 0u);  // as much as rounding moves an edge
  EXPECT_EQ(slanted_by(1e-3), 1u);
}

TEST(Blindness, PieceProlongedPastItsEndRule) {
  const auto prolonged = [](EndRule rule, double f, double by) {
    Plan plan = triangle_plan(rule, f);
    plan.pieces[2].end.x += by;
    return found(settled(plan));
  };
  const double share = cheapest_share(Objective{});
  EXPECT_EQ(prolonged(EndRule::kCentre, 0.5, 0.01), Names{"ends"});
  EXPECT_EQ(prolonged(EndRule::kCover, 0, 0.01), Names{"ends"});
  EXPECT_EQ(prolonged(EndRule::kInside, 1, 0.01), Names{"ends"});
  EXPECT_EQ(prolonged(EndRule::kCheapest, share, 0.01), Names{"ends"});
  EXPECT_EQ(prolonged(EndRule::kCheapest, share, 0.0005), Names{});
  EXPECT_EQ(prolonged(EndRule::kCheapest, share, -0.5), Names{});
}

/// Both ends of the piece obey the rule, the land falls away in between.
TEST(Blindness, EndRuleBrokenInTheMiddleOfAPiece) {
  Plan plan = rectangle_plan();
  plan.field.outer = {{0, 0}, {45, 0}, {45, 2.7}, {55, 2.7}, {55, 0}, {100, 0}, {100, 30}, {0, 30}};
  plan.body = {{plan.field.outer, {}}};
  plan.subfields[0].shape = plan.body[0];
  const check::Verdict verdict = check::verify(settled(plan));
  EXPECT_EQ(rules(verdict), Names{"ends"});
  ASSERT_EQ(verdict.violations.size(), 1u);
  EXPECT_NEAR(verdict.violations[0].amount, 10, 1e-6);
  EXPECT_NEAR(verdict.violations[0].at.x, 50, 1e-6);
}

TEST(Blindness, WrongStopFlags) {
  Plan plan = obstacle_plan();
  for (TrackPiece& piece : plan.pieces) piece.stop_at_start = false;
  EXPECT_EQ(found(plan), Names{"stops"});
  plan = obstacle_plan();
  plan.pieces[0].stop_at_end = true;
  EXPECT_EQ(found(plan), Names{"stops"});
}

TEST(Blindness, CutsWhoseEncountersAreMissing) {
  const auto with = [](auto change) {
    Plan plan = obstacle_plan();
    change(plan);
    return found(plan);
  };
  EXPECT_EQ(with([](Plan&) {}), Names{});
  EXPECT_EQ(with([](Plan& p) { p.encounters.pop_back(); }), Names{"encounters"});
  EXPECT_EQ(with([](Plan& p) { p.encounters.clear(); }), Names{"encounters"});
  EXPECT_EQ(with([](Plan& p) { p.encounters[0].obstacles.clear(); }), Names{"encounters"});
  EXPECT_EQ(with([](Plan& p) { p.encounters[0].track = 7; }), Names{"encounters"});
  EXPECT_EQ(with([](Plan& p) { p.encounters[0].at.x = 20; }), Names{"encounters"});
  // Nor does it help to call the two halves different tracks.
  EXPECT_EQ(with([](Plan& p) {
              for (TrackPiece& piece : p.pieces)
                if (piece.track == 3 && piece.start.x == 100) piece.track = 12;
            }),
            Names{"encounters"});
}

/// Land given up has nobody's name, but the cut is an encounter. So is one before a dropped piece.
TEST(Blindness, MissingEncountersBesideDroppedPiecesAndLandGivenUp) {
  Plan plan = given_up_plan();
  EXPECT_EQ(found(plan), Names{});
  plan.encounters.erase(plan.encounters.begin());
  EXPECT_EQ(found(settled(plan)), Names{"encounters"});

  plan = obstacle_plan();
  // West of the obstacle nothing of tracks 4 and 5 was worth the way.
  std::erase_if(plan.pieces, [&plan](const TrackPiece& piece) {
    if (std::max(piece.start.x, piece.end.x) != 40) return false;
    plan.dropped.push_back({piece.start, piece.end, piece.subfield, DroppedFor::kWay});
    return true;
  });
  EXPECT_EQ(found(settled(plan)), Names{});
  Plan too_long = plan;
  too_long.dropped.back().why = DroppedFor::kShort;
  EXPECT_EQ(found(settled(too_long)), Names{"length"}) << "40 m are no short piece";
  plan.encounters.pop_back();
  EXPECT_EQ(found(settled(plan)), Names{"encounters"});
}

TEST(Blindness, CrossingWithoutAPassable) {
  Plan plan = rectangle_plan();
  TrackPiece second = plan.pieces[0];
  plan.pieces[0].end.x = 40;
  second.start.x = 43;
  second.after_crossing = true;
  plan.pieces.insert(plan.pieces.begin() + 1, second);
  EXPECT_EQ(found(settled(plan)), Names{"crossings"});
}

TEST(Blindness, CrossingThatIsNone) {
  Plan other_track = crossing_plan();
  other_track.pieces[1].track = 5;
  EXPECT_EQ(found(other_track), Names{"crossings"});

  Plan first = rectangle_plan();
  first.pieces[0].after_crossing = true;
  EXPECT_EQ(found(settled(first)), Names{"crossings"});

  Plan backwards = crossing_plan();
  std::swap(backwards.pieces[1].start, backwards.pieces[1].end);
  EXPECT_EQ(found(backwards), Names{"crossings"});
}

TEST(Blindness, PieceTooShortToDrive) {
  Plan plan = rectangle_plan();
  plan.pieces[3].start.x = 5.9;
  plan.pieces[3].end.x = 0;
  EXPECT_EQ(found(settled(plan)), Names{"length"});
  plan.machine.min_length_m = 5;
  EXPECT_EQ(found(settled(plan)), Names{});
}

TEST(Blindness, OverlappingAndMissingSubfields) {
  Plan plan = two_subfields_plan();
  plan.subfields[1].shape.outer = {{39, 0}, {100, 0}, {100, 30}, {59, 30}};
  EXPECT_EQ(found(plan), Names{"subfields"});
  plan = two_subfields_plan();
  plan.subfields.push_back({{box(101, 0, 110, 10), {}}, plan.subfields[0].direction});
  EXPECT_EQ(found(plan), Names{"subfields"});
}

TEST(Blindness, UnsoundPieces) {
  const auto with = [](auto change) {
    Plan plan = rectangle_plan();
    change(plan.pieces[4]);
    return found(plan);
  };
  EXPECT_EQ(with([](TrackPiece& p) { p.end = p.start; }), Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.end.x = std::numeric_limits<double>::infinity(); }), Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.subfield = 1; }), Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.subfield = std::numeric_limits<std::size_t>::max(); }),
            Names{"pieces"});
  EXPECT_EQ(with([](TrackPiece& p) { p.end.y += 0.01; }), Names{"pieces"});
}

// Files count from 1, and a number below that is an index beyond all others.
TEST(Blindness, NumbersOfSubfieldsAreToldAsTheFileHasThem) {
  for (const int number : {-4, 0, 2}) {
    Plan plan = rectangle_plan();
    plan.pieces[4].subfield = static_cast<std::size_t>(number) - 1;
    const check::Verdict verdict = check::verify(plan);
    ASSERT_FALSE(verdict.violations.empty());
    EXPECT_EQ(verdict.violations.front().what,
              "piece 5 belongs to subfield " + std::to_string(number) + ", and there are 1");
    EXPECT_EQ(verdict.violations.front().amount, number);
  }
}

TEST(Blindness, UnsoundShapes) {
  Plan plan = rectangle_plan();
  std::swap(plan.field.outer[1], plan.field.outer[2]);
  EXPECT_EQ(found(plan), Names{"shapes"});
  EXPECT_FALSE(check::verify(plan).complete);
  plan = rectangle_plan();
  plan.body[0].outer.resize(2);
  EXPECT_EQ(found(plan), Names{"shapes"});
}

}  // namespace
}  // namespace tramline
