// Plans judged from their files: writing and reading neither breaks a plan nor mends one.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "check/plans.h"
#include "tramline/check/compare_layers.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

using namespace testing_plans;
namespace fs = std::filesystem;

Names judged_from_file(const Plan& plan) {
  const fs::path path = fs::temp_directory_path() / ("tramline-check-" + std::to_string(getpid()) + ".gpkg");
  io::write_plan(plan, path);
  const io::PlanFile file = io::read_plan_file(path);
  fs::remove(path);
  check::Verdict verdict = check::verify(file.plan);
  for (const auto& v : check::compare_swaths(file.plan, file.track_order, file.swaths, file.swath_order))
    verdict.violations.push_back(v);
  for (const auto& v : check::compare_lines(file.plan, file.track_lines)) verdict.violations.push_back(v);
  for (const io::DerivedText& t : file.derived_texts)
    check::compare_text(t.where, t.stored, t.from_shape, t.at, verdict.violations);
  for (const io::DerivedNumber& n : file.derived)
    check::compare_number(n.where, n.stored, n.from_shape, n.at, verdict.violations);
  return rules(verdict);
}

TEST(PlanFiles, plans_that_hold_hold_from_a_file_in_either_frame) {
  const LocalFrame geodetic{true, 13.3, 52.1, 0, 0}, plain{false, 0, 0, 500123.4, 5800456.7};
  for (Plan plan :
       {rectangle_plan(), triangle_plan(EndRule::kCheapest, cheapest_share(Objective{})),
        triangle_plan(EndRule::kInside, 1), obstacle_plan(), two_subfields_plan(), crossing_plan(),
        poles_plan(), turned(poles_plan(0.4), Angle::degrees(33.3), {71.7, -45.1})})
    for (const LocalFrame& frame : {geodetic, plain}) {
      plan.field.frame = frame;
      EXPECT_EQ(judged_from_file(plan), Names{});
    }
}

TEST(PlanFiles, a_faulty_plan_stays_faulty) {
  Plan plan = rectangle_plan();
  plan.pieces.erase(plan.pieces.begin() + 4);
  EXPECT_EQ(judged_from_file(plan), Names{"tally"});
}

}  // namespace
}  // namespace tramline
