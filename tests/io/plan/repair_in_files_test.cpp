// Repairs in plan files: worked ground comes back to the bit, and other plans are written as before.

#include <gtest/gtest.h>

#include <string>

#include "support/temporary_folder.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

Plan repair() {
  Plan plan;
  plan.field.id = "square";
  plan.field.outer = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
  const Ring gap{{20, 20}, {20 + 1.0 / 3, 20}, {20 + 1.0 / 3, 40}, {20, 40}};
  plan.body = {{gap, {}}};
  plan.kind = PlanKind::kRepair;
  plan.worked = {{plan.field.outer, {reversed(gap)}}};
  plan.subfields.push_back({plan.body.front(), Direction::clockwise_from_north(Angle::degrees(0))});
  plan.pieces.push_back({{20, 20}, {20, 40}, 0, 0});
  return plan;
}

TEST(RepairInFiles, WorkedGroundComesBackToTheBit) {
  const testing_support::TemporaryFolder folder;
  const Plan plan = repair();
  io::write_plan(plan, folder.path() / "repair.gpkg");
  const Plan back = io::read_plan(folder.path() / "repair.gpkg");
  EXPECT_EQ(back.worked, plan.worked);
  EXPECT_TRUE(is_repair(back));
}

TEST(RepairInFiles, HaveTheVersionOfAllPlans) {
  Plan plan = repair();
  EXPECT_EQ(io::metadata_of(plan).at("format_version"), "6");
  plan.worked.clear();
  EXPECT_EQ(io::metadata_of(plan).at("format_version"), "6");
}

}  // namespace
}  // namespace tramline
