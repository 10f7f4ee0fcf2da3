// A whole route over given tracks and headland passes: their order, and the ways between them on the land of
// the field.

#include <benchmark/benchmark.h>

#include "tramline/planner/plan_field.h"
#include "tramline/route/build/planned_route.h"
#include "tramline/route/order/best_tour.h"
#include "tramline/route/turning/turning_land.h"

namespace tramline::bench {
namespace {

constexpr double kWidth_m = 6, kRadius_m = 6;
constexpr int kPasses = 3;

/// A field for about so many tracks, with an oblique edge and three headland passes.
Field field_of(std::size_t tracks) {
  const double width_m = kWidth_m * static_cast<double>(tracks + 2 * kPasses);
  Field out;
  out.id = "oblique";
  out.outer = {{0, 0}, {width_m, 0}, {width_m, 300}, {0, 450}};
  return out;
}

Plan tracks_alone(const Field& field) {
  Machine machine;
  machine.width_m = kWidth_m;
  machine.radius_m = kRadius_m;
  PlanSettings settings;
  settings.boundary = EdgeKind::kHard;
  settings.headlands = kPasses;
  settings.guide = {{0, 0}, {0, 450}};
  return plan_field(field, machine, {}, settings, 1);
}

/// A plan of tracks and passes, with all that its route is planned on.
struct Tracks {
  explicit Tracks(std::size_t tracks)
      : plan(tracks_alone(field_of(tracks))),
        land(turning_land(plan.field, plan.machine, plan.settings)),
        task{plan.field, plan.machine, plan.settings, plan.headland, plan.body, land, beside, for_narrower},
        lines(order::lines_of(plan.pieces)) {}

  Plan plan;
  AllowedLand land;
  LinesBesideBoundaries beside;
  LinesForNarrower for_narrower;
  RouteTask task;
  std::vector<order::WorkedLine> lines;
};

void whole_route(benchmark::State& state) {
  const Tracks on(static_cast<std::size_t>(state.range(0)));
  const order::Tour adjacent = order::best_tour(on.lines, on.plan.field, kWidth_m);
  const order::Tour skip = order::skip_tour(on.lines, on.plan.field, kWidth_m, 2);
  PlannedRoute route;
  for (auto _ : state) route = planned_route(on.task, on.lines, {adjacent, skip});
  double turning_m = 0;
  for (const RouteLeg& leg : route.legs)
    if (!leg.work) turning_m += length(leg.path);
  state.counters["tracks"] = static_cast<double>(on.lines.size());
  state.counters["turning_m"] = turning_m;
}
BENCHMARK(whole_route)->Arg(150)->Arg(377)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
