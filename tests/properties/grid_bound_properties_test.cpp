#include "tramline/cost/bound/grid_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "properties/grid_scene.h"

namespace tramline {
namespace {

/// One subfield with everything that its tallies and bounds depend on.
struct Case {
  Polygon part;
  ClassifiedGround ground;
  GridTerms grid;
  BoundTerms bound;

  GridTally tally(double degrees) const {
    const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(degrees)));
    return {frame,
            part,
            {frame.to_track(ground.hard), frame.to_track(ground.passable), {}, frame.to_track(ground.beyond)},
            grid};
  }
  double origin(const GridTally& tally, double offset_m) const {
    return tally.subfield().frame.to_track(bound.pivot).x + offset_m;
  }
  double cost_at(double degrees, double offset_m) const {
    const GridTally tally = this->tally(degrees);
    const Tally sum = tally.at(origin(tally, offset_m));
    const Objective& price = bound.objective;
    return price.overlap * sum.overlap_m2 + price.uncovered * sum.uncovered_m2 +
           price.turn * (sum.pieces - sum.crossings) + price.stop * sum.stops;
  }
};

// Whatever the grid within the box: more expensive than the bound. Obstacles cut tracks here, which is one of
// the things that detours may be.
TEST(GridBound, NoGridOfTheBoxCostsLess) {
  const int cases = testing::case_count(300);
  for (int i = 0; i < cases; ++i) {
    testing::GridScene scene(i, i % 3 == 0 ? 4 : 0, 12);
    const double width_m = scene.width_m;
    const ClassifiedGround& ground = scene.ground;
    if (ground.plannable.empty()) continue;
    Objective objective = scene.objective();
    if (i % 4 == 1)
      (scene.random() % 2 == 0 ? objective.overlap : objective.uncovered) = std::pow(10, scene.between(0, 5));
    for (const EndRule rule : testing::kEndRules) {
      const Polygon part = ground.plannable[scene.random() % ground.plannable.size()];
      const Case one{
          part,
          ground,
          {width_m, i % 2 == 0 ? 0 : scene.between(0, 4 * width_m), end_criterion(rule, objective, width_m)},
          {objective, bounds(part).centre(), 2 * width_m}};
      const double degrees = scene.between(0, 180), offset_m = scene.between(0, width_m);
      const double half_degrees = std::pow(10, scene.between(-4, 0)),
                   half_m = width_m * std::pow(10, scene.between(-4, -0.3));
      const GridTally middle = one.tally(degrees);
      const double least = least_cost(
          middle, one.bound, {one.origin(middle, offset_m), half_m, half_degrees * std::numbers::pi / 180});
      for (int k = 0; k < 20; ++k)
        EXPECT_GE(one.cost_at(degrees + scene.between(-half_degrees, half_degrees),
                              offset_m + scene.between(-half_m, half_m)),
                  least * (1 - 1e-9) - 1e-9);
    }
  }
}

// Asked only whether a box reaches so much, the bound may stop short, but never says more than the whole.
TEST(GridBound, StopsWhereItIsEnough) {
  const int cases = testing::case_count(100);
  int stopped = 0;
  for (int i = 0; i < cases; ++i) {
    testing::GridScene scene(i, i % 3 == 0 ? 4 : 0, 12);
    const double width_m = scene.width_m;
    const ClassifiedGround& ground = scene.ground;
    if (ground.plannable.empty()) continue;
    const Objective objective = scene.objective();
    const Polygon part = ground.plannable.front();
    const Case one{part,
                   ground,
                   {width_m, 0, end_criterion(EndRule::kCheapest, objective, width_m)},
                   {objective, bounds(part).centre(), 2 * width_m}};
    const GridTally middle = one.tally(scene.between(0, 180));
    const GridBox box{one.origin(middle, scene.between(0, width_m)),
                      width_m * std::pow(10, scene.between(-4, -0.3)), std::pow(10, scene.between(-6, -2))};
    const double whole = least_cost(middle, one.bound, box);
    for (const double share : {0.1, 0.5, 0.9, 1.1}) {
      const double part_of_it = least_cost(middle, one.bound, box, share * whole);
      EXPECT_LE(part_of_it, whole * (1 + 1e-12));
      EXPECT_TRUE(part_of_it >= share * whole || part_of_it == whole) << part_of_it << " of " << whole;
      stopped += part_of_it < whole ? 1 : 0;
    }
  }
  EXPECT_GT(stopped, cases / 10);
}

// With nothing in the way and the cheapest ends, a box that is a point has the cost itself as its bound, but
// for pieces at the verge of being driven; short ones that are left included.
TEST(GridBound, OfAPointIsTheCost) {
  const int cases = testing::case_count(100);
  int equal = 0, compared = 0;
  for (int i = 0; i < cases; ++i) {
    testing::GridScene scene(i, 0, 8);
    const double width_m = scene.width_m;
    const Objective objective = scene.objective(0);
    const Case one{{scene.field.outer, {}},
                   {},
                   {width_m, i % 2 == 0 ? 0 : scene.between(0, 4 * width_m),
                    end_criterion(EndRule::kCheapest, objective, width_m)},
                   {objective, bounds(scene.field.outer).centre(), 0}};
    const double degrees = scene.between(0, 180), offset_m = scene.between(0, width_m);
    const GridTally middle = one.tally(degrees);
    const double cost = one.cost_at(degrees, offset_m);
    const double least = least_cost(middle, one.bound, {one.origin(middle, offset_m), 1e-9, 1e-12});
    EXPECT_LE(least, cost * (1 + 1e-9));
    ++compared;
    equal += least > cost * 0.999 ? 1 : 0;
  }
  EXPECT_GE(equal, compared * 9 / 10);
}

}  // namespace
}  // namespace tramline
