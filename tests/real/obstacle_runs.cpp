#include "real/obstacle_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

/// Of the calling thread, on which plan_field runs with one thread: what others do does not count.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void append(const char* avoid, const std::vector<std::string>& more, ObstacleRun& out) {
  for (const std::string& fault : more) out.faults.push_back(fmt::format("{}: {}", avoid, fault));
}

PlanFigures verified(const Field& field, const Machine& machine, Avoidance avoid, ObstacleRun& out) {
  Plan plan;
  const PlanFigures figures = planned(field, machine, Objective{}, avoid, plan);
  append(name(avoid), faults_of(plan), out);
  return figures;
}

PlanFigures verified_file(const Field& field, const Field& input, const Machine& machine,
                          const std::string& scratch, ObstacleRun& out) {
  Plan plan;
  const PlanFigures figures = planned(field, machine, Objective{}, Avoidance::kCheapest, plan);
  io::write_plan(plan, scratch);
  append("cheapest", faults_of_file(scratch, input), out);
  std::filesystem::remove(scratch);
  return figures;
}

void compare(const char* avoid, const PlanFigures& other, ObstacleRun& out) {
  const double tolerance = 1e-9 * std::max(1.0, other.cost);
  if (other.tight == 0 && out.cheapest.cost > other.cost + tolerance)
    out.faults.push_back(
        fmt::format("cheapest costs {:.6f}, {} only {:.6f}", out.cheapest.cost, avoid, other.cost));
  if (out.cheapest.directions_tried != other.directions_tried)
    out.faults.push_back(fmt::format("cheapest tried {} directions, {} {}", out.cheapest.directions_tried,
                                     avoid, other.directions_tried));
}

}  // namespace

PlanFigures figures_of(const Plan& plan) {
  PlanFigures out;
  out.tally = plan.tally;
  out.cost = plan.cost;
  out.met = static_cast<int>(plan.encounters.size());
  out.round = static_cast<int>(std::count_if(plan.encounters.begin(), plan.encounters.end(),
                                             [](const Encounter& e) { return e.chosen != Passing::kCut; }));
  out.directions_tried = plan.directions_tried;
  const double least_m = std::max(plan.machine.radius_m, 0.5 * plan.machine.width_m) * (1 - 1e-9);
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) out.tight += smallest_radius(detour.path) < least_m ? 1 : 0;
  return out;
}

PlanFigures planned(const Field& field, const Machine& machine, const Objective& objective, Avoidance avoid,
                    Plan& plan) {
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.avoid = avoid;
  const double start = processor_seconds();
  plan = plan_field(field, machine, objective, settings, 1);
  const double seconds = processor_seconds() - start;
  PlanFigures out = figures_of(plan);
  out.seconds = seconds;
  return out;
}

ObstacleRun run_obstacles(const Field& field, const Field& input, const Machine& machine,
                          const std::string& scratch) {
  ObstacleRun out;
  out.field_id = field.id;
  try {
    out.cut = verified(field, machine, Avoidance::kCut, out);
    out.paper = verified(field, machine, Avoidance::kPaper, out);
    out.cheapest = verified_file(field, input, machine, scratch, out);
    compare("paper", out.paper, out);
    compare("cut", out.cut, out);
  } catch (const Error& error) {
    // The first of the three may find that nothing can be planned: then the others would have to, too.
    const bool first = out.cut.directions_tried == 0;
    const bool no_room = std::string(error.what()).find("no track fits") != std::string::npos;
    if (first && no_room)
      out.refused = error.what();
    else
      out.faults.push_back(std::string("the run failed: ") + error.what());
  }
  return out;
}

}  // namespace tramline::testing
