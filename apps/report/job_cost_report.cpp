#include "report/job_cost_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/report_parts.h"
#include "tramline/model/plain_zero.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

constexpr double kHour_s = 3600, kHectare_m2 = 1e4;
constexpr const char* kJobRow = "{:<24} {:<12} {:>9} {:>9} {:>9} {:>9} {:>11} {:>9} {:>7}\n";

double efficiency_pct(const JobCost& job) { return 100 * job.cost.field_efficiency; }

/// The sums of each machine's jobs, in the order in which machines come first.
std::vector<JobCost> sums_of(const std::vector<JobCost>& jobs) {
  std::vector<JobCost> out;
  std::vector<double> ideal_m2;
  for (const JobCost& job : jobs) {
    if (!job.refusal.empty()) continue;
    auto at =
        std::find_if(out.begin(), out.end(), [&](const JobCost& sum) { return sum.machine == job.machine; });
    if (at == out.end()) {
      out.push_back({"all fields", job.machine, 0, 0, {}, {}});
      ideal_m2.push_back(0);
      at = out.end() - 1;
    }
    at->land_m2 += job.land_m2;
    at->route_m += job.route_m;
    at->cost += job.cost;
    if (job.cost.field_efficiency > 0)
      ideal_m2[static_cast<std::size_t>(at - out.begin())] += job.land_m2 / job.cost.field_efficiency;
  }
  // A sum of one is none.
  const auto planned =
      std::count_if(jobs.begin(), jobs.end(), [](const JobCost& job) { return job.refusal.empty(); });
  if (static_cast<std::size_t>(planned) == out.size()) return {};
  for (std::size_t i = 0; i < out.size(); ++i)
    if (ideal_m2[i] > 0) out[i].cost.field_efficiency = out[i].land_m2 / ideal_m2[i];
  return out;
}

std::vector<std::string> cells_of(const JobCost& job) {
  if (!job.refusal.empty()) return {job.field_id, job.machine, "", "", "", "", "", "", ""};
  const double ha = job.land_m2 / kHectare_m2, euros = plain_zero(job.cost.euros());
  return {job.field_id,
          job.machine,
          fmt::format("{:.2f}", ha),
          fmt::format("{:.2f}", job.cost.time_s() / kHour_s),
          fmt::format("{:.1f}", job.cost.fuel_l),
          fmt::format("{:.2f}", job.route_m / 1e3),
          fmt::format("{:.2f}", euros),
          fmt::format("{:.2f}", ha > 0 ? euros / ha : 0),
          fmt::format("{:.1f}", efficiency_pct(job))};
}

const std::vector<std::string> kHead{"field", "machine", "ha",   "hours", "litres",
                                     "km",    "euros",   "€/ha", "eff. %"};

std::string line_of(const std::vector<std::string>& c) {
  return fmt::format(kJobRow, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
}

}  // namespace

std::string machine_text(const Machine& machine) {
  return machine.name.empty() ? fmt::format("{:g} m", machine.width_m) : machine.name;
}

JobCost job_cost(const Plan& plan) {
  return {plan.field.id,    machine_text(plan.machine),
          land_m2(plan),    sums_of(plan.route).length_m,
          whole_cost(plan), {}};
}

std::string job_cost_head() { return line_of(kHead); }

std::string job_cost_row(const JobCost& job) {
  if (!job.refusal.empty())
    return fmt::format("{} refused{}: {}\n", job.field_id, job.machine.empty() ? "" : " for " + job.machine,
                       job.refusal);
  return line_of(cells_of(job));
}

std::string job_cost_sum_rows(const std::vector<JobCost>& jobs) {
  std::string out;
  for (const JobCost& sum : sums_of(jobs)) out += line_of(cells_of(sum));
  return out;
}

JobCostCells job_cost_cells(const std::vector<JobCost>& jobs) {
  JobCostCells out{kHead, {}, {}};
  for (const JobCost& job : jobs)
    if (job.refusal.empty()) out.rows.push_back(cells_of(job));
  for (const JobCost& sum : sums_of(jobs)) out.sums.push_back(cells_of(sum));
  return out;
}

std::string job_cost_csv(const std::vector<JobCost>& jobs) {
  std::string out =
      "field_id,machine,land_m2,hours,working_h,headland_h,turning_h,transit_h,litres,route_m,euros,"
      "euros_without_room,field_efficiency,error\n";
  for (const JobCost& job : jobs) {
    out += csv_text(job.field_id) + "," + csv_text(job.machine) + ",";
    if (!job.refusal.empty()) {
      out += ",,,,,,,,,,," + csv_text(job.refusal) + "\n";
      continue;
    }
    const WholeCost& cost = job.cost;
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},\n", job.land_m2, cost.time_s() / kHour_s,
                       cost.working_s / kHour_s, cost.headland_s / kHour_s, cost.turning_s / kHour_s,
                       cost.transit_s / kHour_s, cost.fuel_l, job.route_m, plain_zero(cost.euros()),
                       cost.without_room, cost.field_efficiency);
  }
  return out;
}

ordered_json job_cost_json(const JobCost& job) {
  ordered_json out{{"field_id", job.field_id}, {"machine", job.machine}};
  if (!job.refusal.empty()) {
    out["error"] = job.refusal;
    return out;
  }
  const WholeCost& cost = job.cost;
  out.update(ordered_json{{"land_m2", job.land_m2},
                          {"hours", cost.time_s() / kHour_s},
                          {"working_h", cost.working_s / kHour_s},
                          {"headland_h", cost.headland_s / kHour_s},
                          {"turning_h", cost.turning_s / kHour_s},
                          {"transit_h", cost.transit_s / kHour_s},
                          {"litres", cost.fuel_l},
                          {"route_m", job.route_m},
                          {"euros", cost.euros()},
                          {"field_efficiency", cost.field_efficiency}});
  return out;
}

ordered_json job_cost_sums_json(const std::vector<JobCost>& jobs) {
  ordered_json sums = ordered_json::array();
  for (JobCost& sum : sums_of(jobs)) {
    ordered_json one = job_cost_json(sum);
    one.erase("field_id");
    sums.push_back(std::move(one));
  }
  return {{"sums", std::move(sums)}};
}

}  // namespace tramline::app
