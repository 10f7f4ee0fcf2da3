// What planning costs: one candidate direction, the whole sweep, and the road through polygon
// booleans that the closed form replaces.

#include <benchmark/benchmark.h>

#include "papers_field.h"
#include "tramline/cost/grid/grid_tally.h"
#include "tramline/cost/strip_tally.h"
#include "tramline/decomposition/candidate_directions.h"
#include "tramline/decomposition/decompose.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/sweep_search.h"

namespace tramline::bench {
namespace {

PlanSettings papers_settings() {
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.end_rule = EndRule::kCentre;
  settings.merge_threshold = Angle::degrees(15);
  settings.decomposition_threshold = Angle::degrees(205);
  return settings;
}

const Objective kFewestTurns{1, 1, 99999, 0};

void count_directions(benchmark::State& state, int directions) {
  state.counters["directions"] = directions;
  state.counters["directions/s"] =
      benchmark::Counter(static_cast<double>(directions), benchmark::Counter::kIsIterationInvariantRate);
}

/// Versleijen's whole search on one core; its aim is 20 ms, Versleijen took 84.34 s for as many directions.
void sweep_of_papers_field(benchmark::State& state) {
  const PlanningProblem problem{papers_field(), {}, kFewestTurns, papers_settings()};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  int directions = 0;
  for (auto _ : state) directions = sweep_search(task, SearchContext(1)).directions_tried;
  count_directions(state, directions);
}
BENCHMARK(sweep_of_papers_field)->Unit(benchmark::kMillisecond);

void sweep_of_papers_field_in_convex_cells(benchmark::State& state) {
  PlanSettings settings = papers_settings();
  settings.decomposition_threshold = Angle::degrees(180);
  const PlanningProblem problem{papers_field(), {}, kFewestTurns, settings};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  int directions = 0;
  for (auto _ : state) directions = sweep_search(task, SearchContext(1)).directions_tried;
  count_directions(state, directions);
}
BENCHMARK(sweep_of_papers_field_in_convex_cells)->Unit(benchmark::kMillisecond);

void sweep_of_large_field(benchmark::State& state) {
  const PlanningProblem problem{large_field(1300, 19), {}, kFewestTurns, papers_settings()};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  int directions = 0;
  for (auto _ : state) directions = sweep_search(task, SearchContext(1)).directions_tried;
  count_directions(state, directions);
}
BENCHMARK(sweep_of_large_field)->Unit(benchmark::kMillisecond);

void whole_plan_of_papers_field(benchmark::State& state) {
  const Field field = papers_field();
  for (auto _ : state) benchmark::DoNotOptimize(plan_field(field, {}, kFewestTurns, papers_settings(), 1));
}
BENCHMARK(whole_plan_of_papers_field)->Unit(benchmark::kMillisecond);

void decomposition_of_one_direction(benchmark::State& state) {
  const PlanningProblem problem{papers_field(), {}, kFewestTurns, papers_settings()};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  const Direction sweep = candidate_directions(task.field).front();
  for (auto _ : state) benchmark::DoNotOptimize(decompose(task.ground.plannable, sweep, task.settings));
}
BENCHMARK(decomposition_of_one_direction)->Unit(benchmark::kMicrosecond);

/// The aim: 20 µs at 200 vertices and 150 tracks, with and without obstacles.
void tally_of_one_direction(benchmark::State& state) {
  const Field field = large_field(200, static_cast<int>(state.range(0)));
  const ClassifiedGround ground = classify_obstacles(field, 1);
  const Polygon& shape = ground.plannable.front();
  const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(31)));
  const Box reach = bounds(frame.to_track(shape.outer));
  const double width_m = reach.width() / 150;
  const GridTerms terms{width_m, 2 * width_m, end_criterion(EndRule::kCheapest, {}, width_m)};
  for (auto _ : state) {
    const GridTally tally(frame, shape, {frame.to_track(ground.hard), {}, {}, {}}, terms);
    benchmark::DoNotOptimize(tally.at(reach.min_x));
  }
}
BENCHMARK(tally_of_one_direction)->Arg(0)->Arg(8)->Unit(benchmark::kMicrosecond);

void closed_form_tally_of_one_candidate(benchmark::State& state) {
  const PlanningProblem problem{papers_field(), {}, kFewestTurns, papers_settings()};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  const Candidate candidate = candidate_on(task, swept(task, candidate_directions(task.field).front()));
  for (auto _ : state)
    benchmark::DoNotOptimize(tally_of(candidate.subfields, candidate.avoided.tracks, task.body_m2));
}
BENCHMARK(closed_form_tally_of_one_candidate)->Unit(benchmark::kMicrosecond);

void boolean_tally_of_one_candidate(benchmark::State& state) {
  const Plan plan = plan_field(papers_field(), {}, kFewestTurns, papers_settings(), 1);
  const Region worked = swaths(plan);
  for (auto _ : state) benchmark::DoNotOptimize(area(intersection(unite(worked), plan.body)));
}
BENCHMARK(boolean_tally_of_one_candidate)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tramline::bench
