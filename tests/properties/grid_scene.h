#pragma once
// A random field to lay grids of tracks on, and what else grids are tried with.

#include <random>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/avoidance/obstacles/obstacle_classification.h"
#include "tramline/cost/strip_tally.h"

namespace tramline::testing {

inline constexpr EndRule kEndRules[] = {EndRule::kCentre, EndRule::kCover, EndRule::kInside,
                                        EndRule::kCheapest};

/// Whatever is drawn comes from the seed of the case.
struct GridScene {
  GridScene(int number, int most_obstacles, double widest_m)
      : random(number),
        field(random_field(random, most_obstacles)),
        width_m(between(1, widest_m)),
        ground(classify_obstacles(field, width_m)) {}

  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
  Objective objective() { return {between(0, 1), between(0, 1), between(0, 3), between(0, 3)}; }
  /// Overlap and uncovered land have random prices, turns and stops this one.
  Objective objective(double each) { return {between(0, 1), between(0, 1), each, each}; }

  SeededRandom random;
  Field field;
  double width_m;
  ClassifiedGround ground;
};

}  // namespace tramline::testing
