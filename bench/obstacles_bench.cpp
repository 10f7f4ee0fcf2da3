// What it costs to decide how tracks get past obstacles.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "tramline/avoidance/choice/detour_decisions.h"
#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/sweep_search.h"

namespace tramline::bench {
namespace {

Ring pole(Point centre, double radius, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.3) / corners;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

/// 21 ha, concave, with a line of 28 pylons of 2 to 12 m² across it.
Field pylon_field() {
  Field field;
  field.id = "pylons";
  field.outer = {{0, 0},     {250, -20}, {520, 0},   {560, 180}, {540, 400},
                 {390, 420}, {360, 300}, {240, 290}, {230, 430}, {30, 420}};
  for (int i = 0; i < 28; ++i) {
    const double t = i / 27.0;
    const double size = 0.8 + 1.2 * std::abs(std::sin(2.3 * i));
    field.obstacles.push_back({{pole({20 + 510 * t, 60 + 190 * t + 3 * std::sin(5.0 * i)}, size, 6), {}},
                               ObstacleKind::kObstacle,
                               "hole"});
  }
  return field;
}

/// One track and one pole: both ways round, their areas, and the choice between them and a cut.
void one_decision_at_a_pole(benchmark::State& state) {
  Field field;
  field.outer = {{0, 0}, {400, 0}, {400, 300}, {0, 300}};
  field.obstacles = {{{pole({200, 154.2}, 1, 16), {}}, ObstacleKind::kObstacle, "hole"}};
  const PlanningProblem problem{field, {}, {}, {}};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  const Candidate candidate =
      candidate_on(task, swept(task, Direction::clockwise_from_north(Angle::degrees(90))));
  const TrackFamily& family = candidate.families.front();
  const Surroundings around =
      turned_surroundings(task.ground, field.outer, EdgeKind::kSoft, family.grid.frame);
  std::vector<Ring> body;
  for (const Ring& ring : rings_of(task.ground.body)) body.push_back(family.grid.frame.to_track(ring));
  WorkedGround ground(candidate.families);
  std::size_t blocked = 0;
  for (std::size_t i = 0; i < family.tracks.size(); ++i) {
    ground.set(0, i, {family.tracks[i].stretches, {}});
    if (!hard_gaps(family.tracks[i]).empty()) blocked = i;
  }
  const Track& strip = family.tracks[blocked];
  for (auto _ : state) {
    BlockedTrack track;
    track.place = blocked;
    track.gaps = hard_gaps(strip);
    for (const Passing side : {Passing::kLeft, Passing::kRight}) {
      WayRound way = way_round({family.grid, strip, track.gaps.front(), 6}, side, around);
      track.options.push_back(option_of(std::move(way), family.grid, strip));
    }
    value_options(track, family, body, ground, 6);
    benchmark::DoNotOptimize(cheapest_choice(track, strip, 3, task.objective, 6));
  }
}
BENCHMARK(one_decision_at_a_pole)->Unit(benchmark::kMicrosecond);

/// All meetings of tracks with the pylons, for one direction of the tracks: options, areas, choice.
void decisions_at_pylons(benchmark::State& state) {
  const PlanningProblem problem{pylon_field(), {}, {}, {}};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  const Direction sweep = Direction::clockwise_from_north(Angle::degrees(90));
  const Candidate candidate = candidate_on(task, swept(task, sweep));
  const AvoidanceTask avoidance{task.field,    task.ground,         task.machine,       task.objective,
                                task.settings, candidate.subfields, candidate.families, task.body_m2};
  std::size_t meetings = 0;
  for (const TrackFamily& family : candidate.families)
    for (const Track& strip : family.tracks) meetings += hard_gaps(strip).size();
  for (auto _ : state) {
    DetourDecisions decisions(avoidance);
    benchmark::DoNotOptimize(decisions.improve());
  }
  state.counters["meetings"] = static_cast<double>(meetings);
  state.counters["s/meeting"] =
      benchmark::Counter(static_cast<double>(meetings),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(decisions_at_pylons)->Unit(benchmark::kMicrosecond);

void sweep_of_pylon_field(benchmark::State& state) {
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.avoid = static_cast<Avoidance>(state.range(0));
  const PlanningProblem problem{pylon_field(), {}, {}, settings};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  int directions = 0;
  for (auto _ : state) directions = sweep_search(task, SearchContext(1)).directions_tried;
  state.SetLabel(name(settings.avoid));
  state.counters["directions"] = directions;
}
BENCHMARK(sweep_of_pylon_field)
    ->Arg(static_cast<int>(Avoidance::kCheapest))
    ->Arg(static_cast<int>(Avoidance::kPaper))
    ->Arg(static_cast<int>(Avoidance::kCut))
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
