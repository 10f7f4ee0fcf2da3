#include "tramline/cost/bound/obstacle_edges.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

// A square field of 100 m with one obstacle on its upper border, one inside, and one that reaches beyond the
// border at the right.
TEST(ObstacleEdges, AreThoseThatTheLandSharesWithAnObstacle) {
  const Ring outer{{0, 0},     {100, 0},  {100, 40}, {90, 40}, {90, 60},  {100, 60},
                   {100, 100}, {60, 100}, {60, 80},  {40, 80}, {40, 100}, {0, 100}};
  const Ring hole{{20, 20}, {20, 30}, {30, 30}, {30, 20}};
  const Region obstacles{{{{40, 80}, {60, 80}, {60, 100}, {40, 100}}, {}},
                         {{{20, 20}, {30, 20}, {30, 30}, {20, 30}}, {}},
                         {{{90, 40}, {120, 40}, {120, 60}, {90, 60}}, {}}};
  const std::vector<bool> expected{
      // The edge to each corner of the outer ring …
      false, false, false, true, true, true, false, false, true, true, true, false,
      // … and of the hole.
      true, true, true, true};
  EXPECT_EQ(edges_at_obstacles({outer, hole}, obstacles), expected);
  EXPECT_EQ(edges_at_obstacles({outer, hole}, {}), std::vector<bool>(16, false));
}

}  // namespace
}  // namespace tramline
