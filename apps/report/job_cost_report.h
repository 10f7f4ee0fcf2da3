#pragma once
// What the work on fields costs, one row a field and machine.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::app {

/// What one machine takes on one field.
struct JobCost {
  std::string field_id;
  std::string machine;  ///< its name, or "6 m"
  double land_m2 = 0;
  double route_m = 0;
  WholeCost cost;
  std::string refusal{};  ///< why there is no plan; empty: there is one
};

/// The machine's name, or its width where it has none.
std::string machine_text(const Machine& machine);
/// Of a plan that has a route.
JobCost job_cost(const Plan& plan);

/// The table as text: its head, a row, and the last rows with the sums of each machine, where
/// there is more than one field.
std::string job_cost_head();
std::string job_cost_row(const JobCost& job);
std::string job_cost_sum_rows(const std::vector<JobCost>& jobs);

/// The cells of a table of these jobs with a head and the sums, one row a machine, as text for people.
struct JobCostCells {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::vector<std::string>> sums;
};
JobCostCells job_cost_cells(const std::vector<JobCost>& jobs);

std::string job_cost_csv(const std::vector<JobCost>& jobs);
nlohmann::ordered_json job_cost_json(const JobCost& job);
/// {"sums": [...]}, one for each machine.
nlohmann::ordered_json job_cost_sums_json(const std::vector<JobCost>& jobs);

}  // namespace tramline::app
