// What the work on several fields costs together, by hand.

#include "report/job_cost_report.h"

#include <gtest/gtest.h>

namespace tramline::app {
namespace {

JobCost job(const char* field, const char* machine, double land_m2, double hours, double efficiency) {
  JobCost out{field, machine, land_m2, 1000, {}, {}};
  out.cost.working_s = 3600 * hours;
  out.cost.fuel_l = 10 * hours;
  out.cost.hours = 90 * hours;
  out.cost.field_efficiency = efficiency;
  return out;
}

// 1 ha at 50 % is as much as 2 ha without turning, 3 ha at 75 % as much as 4 ha: together 4 of 6 ha, 66.7 %.
// Not the mean of both, which is 62.5 %.
TEST(JobCosts, AreSummedByMachine) {
  const std::vector<JobCost> jobs{job("north", "drill", 1e4, 1, 0.5), job("south", "drill", 3e4, 2, 0.75),
                                  job("north", "sprayer", 1e4, 0.25, 0.4)};
  const auto sums = job_cost_sums_json(jobs)["sums"];
  ASSERT_EQ(sums.size(), 2U);
  EXPECT_EQ(sums[0]["machine"], "drill");
  EXPECT_DOUBLE_EQ(sums[0]["land_m2"], 4e4);
  EXPECT_DOUBLE_EQ(sums[0]["hours"], 3);
  EXPECT_DOUBLE_EQ(sums[0]["litres"], 30);
  EXPECT_DOUBLE_EQ(sums[0]["euros"], 270);
  EXPECT_DOUBLE_EQ(sums[0]["route_m"], 2000);
  EXPECT_NEAR(sums[0]["field_efficiency"], 4.0 / 6, 1e-12);
  EXPECT_EQ(sums[1]["machine"], "sprayer");
  EXPECT_DOUBLE_EQ(sums[1]["euros"], 22.5);
  const std::string row = job_cost_row(jobs[1]);
  EXPECT_NE(row.find(" 3.00 "), std::string::npos) << row;   // ha
  EXPECT_NE(row.find(" 60.00 "), std::string::npos) << row;  // €/ha: 180 € over 3 ha
  EXPECT_NE(row.find(" 75.0\n"), std::string::npos) << row;  // field efficiency
}

TEST(JobCosts, OfOneFieldHaveNoSum) {
  EXPECT_EQ(job_cost_sum_rows({job("north", "drill", 1e4, 1, 0.5)}), "");
}

TEST(JobCosts, LeaveRefusedFieldsOutOfSums) {
  std::vector<JobCost> jobs{job("north", "drill", 1e4, 1, 0.5), job("south", "drill", 1e4, 2, 0.5), {}};
  jobs[2].field_id = "tiny, \"corner\"";
  jobs[2].refusal = "no track fits";
  EXPECT_DOUBLE_EQ(job_cost_sums_json(jobs)["sums"][0]["hours"], 3);
  EXPECT_EQ(job_cost_cells(jobs).rows.size(), 2U);
  // Of 14 columns the two names and the error are filled.
  EXPECT_NE(job_cost_csv(jobs).find("\"tiny, \"\"corner\"\"\",\"\",,,,,,,,,,,,\"no track fits\"\n"),
            std::string::npos)
      << job_cost_csv(jobs);
}

}  // namespace
}  // namespace tramline::app
