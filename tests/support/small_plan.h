#pragma once
// A plan of two tracks that needs no search, for tests of what becomes of its file.

#include "tramline/geometry/angle.h"
#include "tramline/model/plan.h"

namespace tramline::testing_support {

inline Plan small_plan() {
  Plan plan;
  plan.field.id = "small";
  plan.field.outer = {{0, 0}, {100, 0}, {100, 6}, {0, 6}};
  plan.field.frame = {true, 13, 52, 0, 0};
  plan.body = {{plan.field.outer, {}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  plan.pieces = {{{0, 1.5}, {100, 1.5}, 0, 0}, {{100, 4.5}, {0, 4.5}, 0, 1}};
  return plan;
}

}  // namespace tramline::testing_support
