// Orders of lines in an arm that is backed out of by the way in, where the machine comes to it otherwise.

#include "tramline/route/build/tour_as_driven.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "route/driven_land.h"

namespace tramline::tour_as_driven_test {

using testing::DrivenLand, testing::northwards;

order::WorkedLine track(Point from, Point to) {
  TrackPiece piece;
  piece.start = from;
  piece.end = to;
  return {piece};
}

// The first line lies in the arm, from 6 m north of its mouth on: 51 m, and 64 m have to be backed. The
// others are in the room, and a route that begins with one of them, or at the end of the arm, costs 500 s
// more.
struct ArmFirst {
  DrivenLand on{testing::room_with_an_arm(), testing::six_metres_wide(4)};
  std::vector<RouteLine> lines;
  LeastSeconds least{on.machine};

  ArmFirst() {
    for (const auto& line :
         {track({46.5, 106}, {46.5, 157}), track({20, 60}, {20, 20}), track({26, 20}, {26, 60})})
      lines.push_back(route_line(line, on.machine.turning));
  }

  KnownCosts costs() const {
    KnownCosts out(lines, on.connector, least);
    for (order::End end = 1; end < 2 * lines.size(); ++end) out.set_start(end, 500);
    return out;
  }

  /// Each way in turn, as the machine comes there.
  bool holds(const TrackTour& tour, SteeredPath left) const {
    left.insert(left.end(), lines.front().senses.front().first.begin(),
                lines.front().senses.front().first.end());
    for (std::size_t i = 1; i < tour.tour.size(); ++i) {
      const SteeredPath& work = lines[order::line_of(tour.tour[i])].entered_by(tour.tour[i]).first;
      const Way way = way_on(tour.ways[i - 1], left, work, on.connector);
      if (!way.has_room()) return false;
      left = driven_forward(left, way, work);
    }
    return true;
  }
};

BeforeLines behind(const SteeredPath& left) {
  return {left, [](order::End, const SteeredPath&) { return Way{}; }};
}

TEST(TourAsDriven, StaysWhereTheMachineComesStraightOn) {
  const ArmFirst scene;
  KnownCosts costs = scene.costs();
  const SteeredPath left = northwards({46.5, 80}, 26);
  const TrackTour tour = best_tour_as_driven({}, Senses::kCostTheSame, Patience::kUsual, scene.lines,
                                             behind(left), scene.on.connector, costs);
  EXPECT_EQ(tour.tour.front(), 0U);
  EXPECT_TRUE(tour.ways.front().supposed);
  EXPECT_TRUE(scene.holds(tour, left));
}

TEST(TourAsDriven, IsAnotherWhereNothingWasDrivenBefore) {
  const ArmFirst scene;
  KnownCosts costs = scene.costs();
  const TrackTour supposed = best_tour_with_ways({}, Senses::kCostTheSame, Patience::kUsual, costs);
  ASSERT_EQ(supposed.tour.front(), 0U);
  ASSERT_FALSE(scene.holds(supposed, {}));
  const TrackTour tour = best_tour_as_driven({}, Senses::kCostTheSame, Patience::kUsual, scene.lines,
                                             behind({}), scene.on.connector, costs);
  EXPECT_NE(tour.tour.front(), 0U);
  EXPECT_TRUE(std::ranges::all_of(tour.ways, &Way::has_room));
  // What was refused is known to have no room from now on.
  EXPECT_FALSE(costs.way(1, supposed.tour[1]).has_room());
  EXPECT_GT(costs.between(1, supposed.tour[1]), 1000);
}

// The way from the last line may have room once it is known how the machine came to it; that out of the arm
// has none once it is known how it did.
TEST(KnownCosts, PreferAWayFromTheLastLineThatMayHaveRoomToOneThatHasNone) {
  const ArmFirst scene;
  KnownCosts costs = scene.costs();
  costs.set_way_from_last([](order::End left) {
    Way out;
    out.cost_s = 40;
    out.missing_m = left == 1 ? 20 : 0;
    return out;
  });
  costs.settle_finish(1);
  costs.settle_finish(2);
  EXPECT_EQ(costs.at_finish(2), 40);
  EXPECT_GT(costs.at_finish(1), 40 + 300) << "backing all along the arm instead";
  ASSERT_TRUE(costs.way(1, 2).supposed);
  costs.refuse_supposed(1, 2);
  EXPECT_LT(costs.at_finish(1), costs.between(1, 2));
}

}  // namespace tramline::tour_as_driven_test
