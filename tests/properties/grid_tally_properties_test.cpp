#include "tramline/cost/grid/grid_tally.h"

#include <gtest/gtest.h>

#include "properties/grid_scene.h"

namespace tramline {
namespace {

TurnedGround turned(const ClassifiedGround& ground, const Field& field, const TrackFrame& frame,
                    bool hard_boundary) {
  TurnedGround out{
      frame.to_track(ground.hard), frame.to_track(ground.passable), {}, frame.to_track(ground.beyond)};
  if (hard_boundary) out.field = {{frame.to_track(field.outer), {}}};
  return out;
}

void expect_same(const Tally& a, const Tally& b, double area_m2) {
  EXPECT_EQ(a.pieces, b.pieces);
  EXPECT_EQ(a.stops, b.stops);
  EXPECT_EQ(a.crossings, b.crossings);
  EXPECT_EQ(a.turns, b.turns);
  EXPECT_NEAR(a.worked_m2, b.worked_m2, 1e-9 * (1 + area_m2));
  EXPECT_NEAR(a.overlap_m2, b.overlap_m2, 1e-9 * (1 + area_m2));
  EXPECT_NEAR(a.uncovered_m2, b.uncovered_m2, 1e-9 * (1 + area_m2));
}

// The same numbers by the road through pieces, for random outlines with and without obstacles.
TEST(GridTally, AgreesWithThePiecesOfEveryStrip) {
  const int cases = testing::case_count(200);
  for (int i = 0; i < cases; ++i) {
    testing::GridScene scene(i, i % 3 == 0 ? 4 : 0, 12);
    const double width_m = scene.width_m;
    const ClassifiedGround& ground = scene.ground;
    const bool hard_boundary = i % 5 == 1;
    const Objective objective = scene.objective(1);
    for (const EndRule rule : testing::kEndRules)
      for (const Polygon& part : ground.plannable) {
        if (hard_boundary && (ground.plannable.size() > 1 || part.outer.size() != scene.field.outer.size()))
          continue;
        const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(scene.between(0, 180))));
        const EndCriterion criterion = end_criterion(rule, objective, width_m);
        const double least_m = i % 2 == 0 ? 0 : scene.between(0, 4 * width_m),
                     origin_m = scene.between(0, width_m);
        const TurnedGround around = turned(ground, scene.field, frame, hard_boundary);
        const GridTally quick(frame, part, around, {width_m, least_m, criterion});
        const TrackFamily strips = straight_tracks({frame, origin_m, width_m},
                                                   frame.to_track(Region{part}).front(), around, criterion);
        expect_same(quick.at(origin_m),
                    tally_of({{part, frame.direction()}}, {cut_pieces(strips, least_m)}, area(part)),
                    area(part));
      }
  }
}

}  // namespace
}  // namespace tramline
