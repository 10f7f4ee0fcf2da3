// Plans every curated real field by the best search and by the sweep, and compares.
//
//   best_real [--scenario N] [--width W]
//
// Scenarios 1 to 3 are Versleijen's; 0, the default, are the default prices. Prints a line for everything
// that is not well and a row for docs/performance.md; exit code 1 when a plan fails, is more expensive than
// the sweep's or lies below its bound.

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "real/real_fields.h"
#include "real/spread.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

struct Request {
  int scenario = 0;
  double width_m = 6;
};

struct Comparison {
  std::vector<std::string> faults;
  bool planned = false;
  double saved_pct = 0;
  double gap_pct = 0, one_direction_gap_pct = 0;
  bool undivided = false, hindered = false;
};

Comparison compare(const Field& field, const Request& request) {
  Comparison out;
  const Objective objective = request.scenario == 0 ? Objective{} : scenario(request.scenario);
  PlanSettings settings;
  try {
    const Plan best = plan_field(field, {"", request.width_m, 6, -1}, objective, settings, 1);
    settings.strategy = Strategy::kSweep;
    const Plan sweep = plan_field(field, {"", request.width_m, 6, -1}, objective, settings, 1);
    out.planned = true;
    out.faults = faults_of(best);
    if (best.cost > sweep.cost)
      out.faults.push_back(fmt::format("best costs {:.6f}, the sweep {:.6f}", best.cost, sweep.cost));
    if (best.proof.bound > best.cost || best.proof.one_direction_bound > best.proof.one_direction_cost)
      out.faults.push_back("a bound lies above the cost");
    out.saved_pct = 100 * gap(sweep.cost, best.cost);
    out.gap_pct = 100 * gap(best.cost, best.proof.bound);
    out.one_direction_gap_pct = 100 * gap(best.proof.one_direction_cost, best.proof.one_direction_bound);
    out.undivided = best.cost >= best.proof.one_direction_cost;
    out.hindered = !field.obstacles.empty();
  } catch (const Error& error) {
    add_failure(error, out.faults);
  }
  print_faults(field, out.faults);
  return out;
}

int report(const std::vector<Comparison>& all, const Request& request) {
  int plans = 0, failed = 0;
  std::vector<double> saved, gaps, one_direction, one_direction_free;
  for (const Comparison& one : all) {
    failed += one.faults.empty() ? 0 : 1;
    if (!one.planned) continue;
    ++plans;
    saved.push_back(one.saved_pct);
    gaps.push_back(one.gap_pct);
    if (one.undivided) one_direction.push_back(one.one_direction_gap_pct);
    if (one.undivided && !one.hindered) one_direction_free.push_back(one.one_direction_gap_pct);
  }
  const auto text = [](const std::vector<double>& values) {
    const Spread spread = spread_of(values);
    return fmt::format("{:.2f} ({:.2f} … {:.2f})", spread.median, spread.least, spread.most);
  };
  fmt::print("{} plans, {} fail\n", plans, failed);
  fmt::print("| {} | {:g} | {} | {} | {} | {}: {} | {}: {} |\n",
             request.scenario == 0 ? "default prices" : fmt::format("scenario {}", request.scenario),
             request.width_m, plans, text(saved), text(gaps), one_direction.size(), text(one_direction),
             one_direction_free.size(), text(one_direction_free));
  return failed > 0 ? 1 : 0;
}

int run(int argc, char** argv) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  Request request;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string word = argv[i];
    if (word == "--scenario") request.scenario = std::atoi(argv[i + 1]);
    if (word == "--width") request.width_m = std::atof(argv[i + 1]);
  }
  const std::vector<Comparison> all =
      for_each_field(*fields, [&](const Field& field) { return compare(field, request); });
  return report(all, request);
}

}  // namespace
}  // namespace tramline::testing

int main(int argc, char** argv) { return tramline::testing::run(argc, argv); }
