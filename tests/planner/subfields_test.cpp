// What subfields cost, and that nobody drives two directions that are one.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <set>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"

namespace tramline::subfields_test {

const Machine kMachine{"", 6, 6, -1};

/// Two strips 50 m wide and 400 m long that meet at an angle.
Field bent(double degrees) {
  const double turn = degrees * std::numbers::pi / 180;
  const Point along{std::cos(turn), std::sin(turn)}, aside{-std::sin(turn), std::cos(turn)};
  const Point far = Point{400, 0} + 400.0 * along;
  const double over = 50 * std::tan(0.5 * turn);
  Field field;
  field.id = "bent";
  field.outer = {{0, 0}, {400, 0}, far, far + 50.0 * aside, Point{400, 50} + over * Point{-1, 0}, {0, 50}};
  return field;
}

Objective with_subfield_price(double price) { return {0.02, 0.10, 1.00, 5, price}; }

int subfields_at(const Field& field, double price, Angle merge) {
  PlanSettings settings;
  settings.merge_threshold = merge;
  return plan_field(field, kMachine, with_subfield_price(price), settings).tally.subfields;
}

// Two arms at a right angle are driven along each while a further subfield costs less than the turns that
// the other direction takes, 50 / 6 · … of them; nobody pays 100,000 € for it.
TEST(Subfields, ADividedFieldHasItsPrice) {
  Field field;
  field.id = "angle";
  field.outer = {{0, 0}, {400, 0}, {400, 60}, {60, 60}, {60, 400}, {0, 400}};
  EXPECT_EQ(subfields_at(field, 0, Angle::degrees(1)), 2);
  EXPECT_EQ(subfields_at(field, 100000, Angle::degrees(1)), 1);
}

TEST(Subfields, EachAfterTheFirstIsPaidFor) {
  Field field;
  field.id = "angle";
  field.outer = {{0, 0}, {400, 0}, {400, 60}, {60, 60}, {60, 400}, {0, 400}};
  const Plan plan = plan_field(field, kMachine, with_subfield_price(3), {});
  ASSERT_EQ(plan.tally.subfields, 2);
  const Tally& t = plan.tally;
  EXPECT_NEAR(plan.cost, 0.02 * t.overlap_m2 + 0.10 * t.uncovered_m2 + t.turns + 5 * t.stops + 3, 1e-9);
}

// At 0.6 degrees a division saves wedges, but no driver would set up a second line for it.
TEST(Subfields, DirectionsThatAreOneHaveNoBorder) {
  for (const double degrees : {0.3, 0.6, 0.9})
    EXPECT_EQ(subfields_at(bent(degrees), 0, Angle::degrees(1)), 1);
}

TEST(Subfields, DirectionsOfNeighboursDifferByTheMergeThreshold) {
  for (const double degrees : {1.5, 4.0, 12.0, 40.0}) {
    const Plan plan = plan_field(bent(degrees), kMachine, with_subfield_price(0), {});
    for (const Subfield& a : plan.subfields)
      for (const Subfield& b : plan.subfields)
        if (&a != &b && unite({a.shape}, {b.shape}).size() == 1) {
          EXPECT_GE(angle_between(a.direction, b.direction).degrees(), 1);
        }
  }
}

}  // namespace tramline::subfields_test
