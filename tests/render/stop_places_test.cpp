// Where machines stop, by hand.

#include "tramline/render/stops/stop_places.h"

#include <gtest/gtest.h>

namespace tramline::render {
namespace {

RouteLeg leg(LegKind kind, const Point& from, const Point& to, Gear gear) {
  RouteLeg out;
  out.kind = kind;
  out.gear = gear;
  out.work = kind == LegKind::kWork;
  const Pose start{from, gear == Gear::kForward ? Heading::from_to(from, to) : Heading::from_to(to, from)};
  out.path = {arc_from(start, distance(from, to), 0, gear)};
  return out;
}

void expect_at(const StopPlace& stop, Point at, Point back) {
  EXPECT_NEAR(distance(stop.at, at), 0, 1e-9);
  EXPECT_NEAR(distance(stop.back, back), 0, 1e-9);
}

/// Two tracks to the north, 10 m apart; neither end of the first has a way off.
Plan two_tracks() {
  Plan plan;
  for (const double x : {0.0, 10.0}) {
    TrackPiece piece;
    piece.start = {x, 0};
    piece.end = {x, 100};
    plan.pieces.push_back(piece);
  }
  plan.pieces.front().stop_at_start = plan.pieces.front().stop_at_end = true;
  plan.tally.stops = 2;
  return plan;
}

// Without a route every end without a way off counts, on the track's side of it.
TEST(StopPlaces, AreEndsWithoutAWayOffWhereThereIsNoRoute) {
  const Plan plan = two_tracks();
  EXPECT_EQ(stops(plan), 2U);
  const std::vector<StopPlace> found = stop_places(plan);
  ASSERT_EQ(found.size(), 2U);
  expect_at(found[0], {0, 0}, {0, 1});
  expect_at(found[1], {0, 100}, {0, -1});
}

// The route backs 20 m out of the north end of the first track, and 30 m into the second, which it works to
// the south. It never stops at the south end of the first, where it starts.
TEST(StopPlaces, AreThoseOfTheRoute) {
  Plan plan = two_tracks();
  plan.tally.stops = 7;
  plan.route.legs = {leg(LegKind::kWork, {0, 0}, {0, 100}, Gear::kForward),
                     leg(LegKind::kBackOut, {0, 100}, {0, 80}, Gear::kReverse),
                     leg(LegKind::kTransit, {0, 80}, {10, 70}, Gear::kForward),
                     leg(LegKind::kBackOut, {10, 70}, {10, 100}, Gear::kReverse),
                     leg(LegKind::kWork, {10, 100}, {10, 0}, Gear::kForward)};
  EXPECT_EQ(stops(plan), 2U);
  const std::vector<StopPlace> found = stop_places(plan);
  ASSERT_EQ(found.size(), 2U);
  expect_at(found[0], {0, 100}, {0, -1});
  expect_at(found[1], {10, 100}, {0, -1});
}

}  // namespace
}  // namespace tramline::render
