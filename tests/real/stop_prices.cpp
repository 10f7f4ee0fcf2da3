#include "real/stop_prices.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "real/obstacle_runs.h"
#include "tramline/model/detour_summary.h"

namespace tramline::testing {
namespace {

constexpr const char* kFieldId = "cz/45";

/// Obstacles that tracks meet, and those that all of the tracks which meet them drive round.
struct Pylons {
  int met = 0;
  int round = 0;
};

Pylons pylons_of(const Plan& plan) {
  std::map<std::size_t, bool> always_round;  // by obstacle
  for (const Encounter& encounter : plan.encounters)
    for (const std::size_t obstacle : encounter.obstacles) {
      bool& so_far = always_round.try_emplace(obstacle, true).first->second;
      so_far = so_far && encounter.chosen != Passing::kCut;
    }
  Pylons out;
  out.met = static_cast<int>(always_round.size());
  out.round = static_cast<int>(std::count_if(always_round.begin(), always_round.end(),
                                             [](const auto& entry) { return entry.second; }));
  return out;
}

/// Returns the number of faults. `round` counts the encounters driven round.
int report_price(const Field& field, double price, int& round) {
  Machine machine;
  machine.width_m = 3;
  machine.radius_m = 6;
  Objective objective;
  objective.stop = price;
  Plan plan;
  const PlanFigures figures = planned(field, machine, objective, Avoidance::kCheapest, plan);
  const Pylons pylons = pylons_of(plan);
  fmt::print("| {:g} | {} of {} | {} of {} | {} | {} | {} | {:.2f} |\n", price, pylons.round, pylons.met,
             figures.round, figures.met, summary_of_detours(plan).count(), figures.tally.turns,
             figures.tally.stops, figures.cost);
  const std::vector<std::string> faults = faults_of(plan);
  for (const std::string& fault : faults) fmt::print(stderr, "{}, {} a stop: {}\n", kFieldId, price, fault);
  round = figures.round;
  return static_cast<int>(faults.size());
}

}  // namespace

int run_stop_prices(const RealFields& fields) {
  const auto& features = fields.features();
  const auto found = std::find_if(features.begin(), features.end(),
                                  [](const RawFeature& feature) { return feature.id == kFieldId; });
  if (found == features.end()) {
    fmt::print("skipped: there is no field {}\n", kFieldId);
    return 0;
  }
  const Crs crs(fields.dataset.layers.front().crs);
  const Field field = admitted(fields, crs, *found).front();
  fmt::print(
      "| € a stop | pylons all tracks drive round | encounters driven round | detours | turns | stops | "
      "cost, "
      "€ |\n|--:|--:|--:|--:|--:|--:|--:|\n");
  int faults = 0;
  for (const double price : {0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) {
    int round = 0;
    faults += report_price(field, price, round);
    if (price == Objective{}.stop && round == 0) {
      fmt::print(stderr, "at the default price no pylon is driven round\n");
      ++faults;
    }
  }
  return faults > 0 ? 1 : 0;
}

}  // namespace tramline::testing
