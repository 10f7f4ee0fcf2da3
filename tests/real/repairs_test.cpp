// What five harvesters missed, repaired with machines of two widths: the plans hold, every repair costs
// less than it wins back, and log and repair together leave what the plan says.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "real/real_fields.h"
#include "real/real_logs.h"
#include "tramline/check/verify.h"
#include "tramline/coverage/drive/plan_steps.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/planner/repair/repair_plan.h"

namespace tramline::testing {
namespace {

struct Harvest {
  const char* log;
  const char* partfield;
};

constexpr Harvest kHarvests[] = {{"isoxml_sh2020_TLG00001.csv", "iso-timelogs/ValidTimeLogs-PFD-2"},
                                 {"isoxml_sh2020_TLG00002.csv", "iso-timelogs/ValidTimeLogs-PFD-3"},
                                 {"isoxml_sh2020_TLG00003.csv", "iso-timelogs/ValidTimeLogs-PFD-4"},
                                 {"isoxml_sh2020_TLG00005.csv", "iso-timelogs/ValidTimeLogs-PFD-6"},
                                 {"isoxml_sh2020_TLG00008.csv", "iso-timelogs/ValidTimeLogs-PFD-8"}};

class RealRepairs : public ::testing::Test {
 protected:
  void SetUp() override {
    fields_ = read_real_fields();
    if (!fields_) GTEST_SKIP() << no_real_fields();
  }

  std::optional<RealFields> fields_;
};

TEST_F(RealRepairs, LogAndRepairTogetherLeaveWhatThePlanSays) {
  constexpr double kMinArea_m2 = 1;
  for (const Harvest& harvest : kHarvests) {
    const Field field = field_named(*fields_, harvest.partfield);
    const Region ground = ground_of(field);
    const WorkLog log = real_log(harvest.log, field.frame);
    coverage::EvaluateSettings settings;
    const Coverage before = coverage::evaluate(log, ground, settings, {});
    for (const double width_m : {9.0, 5.0}) {
      SCOPED_TRACE(std::string(harvest.log) + ", w = " + std::to_string(width_m));
      RepairTerms terms;
      terms.machine.width_m = width_m;
      terms.objective = {0.02, 0.10, 1, 5};
      const RepairPlan repair =
          repair_plan(field, before.gaps, before.missed, before.lines, terms, kMinArea_m2, 0, {});
      const check::Verdict verdict = check::verify(repair.plan);
      for (const check::Violation& violation : verdict.violations)
        ADD_FAILURE() << name(violation.rule) << ": " << violation.what;

      const coverage::FurtherWork drive{coverage::plan_steps(repair.plan), {}};
      const Coverage after = coverage::evaluate(log, ground, settings, {}, {}, drive);
      EXPECT_NEAR(after.areas.missed_m2, repair.missed_after_m2, 0.1);
      EXPECT_LT(repair.cost_after, repair.cost_if_left);
      EXPECT_LT(repair.cost_of_passes, 0.10 * (before.areas.missed_m2 - after.areas.missed_m2));
      // A pass that works several gaps in line is one, whatever number of pieces it has.
      EXPECT_LT(repair.plan.tally.turns, 25);
    }
  }
}

}  // namespace
}  // namespace tramline::testing
