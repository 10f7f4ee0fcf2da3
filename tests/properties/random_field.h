#pragma once
// Random fields for property tests: star-shaped outer rings with star-shaped obstacles.

#include <random>

#include "tramline/model/field.h"

namespace tramline::testing {

/// The nearest coordinate on the planner's precision grid.
double on_grid(double value);

/// A star-shaped ring round `centre`: corners at increasing angles, radii between the two bounds.
/// Coordinates lie on the planner's precision grid. Counter-clockwise.
Ring random_star(std::mt19937_64& random, Point centre, double least_radius, double most_radius, int corners);

/// 0.3 to about 12 ha, up to 25 corners, up to `most_obstacles` obstacles of 1 to 25 m radius that
/// overlap neither one another nor the outside; some lie close together or close to the edge.
Field random_field(std::mt19937_64& random, int most_obstacles);

/// The same field moved.
Field shifted(const Field& field, Point by);
/// The same field turned counter-clockwise by a quarter.
Field quarter_turned(const Field& field);

/// How many cases a property is tried on: $TRAMLINE_CASES, or `standard`.
int case_count(int standard);
/// Seed of the run: $TRAMLINE_SEED, or a fixed one. Printed with every failure.
unsigned long long base_seed();

}  // namespace tramline::testing
