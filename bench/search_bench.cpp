// What the search for the best plan costs, and how it grows with corners, obstacles, size and 1/w.

#include <benchmark/benchmark.h>

#include "papers_field.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/search/best_search.h"
#include "tramline/planner/search/branch_and_bound.h"

namespace tramline::bench {
namespace {

constexpr int kTracks = 150;

/// One grid over a field, everything ready to be summed.
struct OneGrid {
  Polygon shape;
  GridTally tally;
  double width_m;
  BoundTerms bound;

  OneGrid(const Field& field, int tracks)
      : shape(classify_obstacles(field, 1).plannable.front()),
        tally(made(field, shape, tracks)),
        width_m(tally.terms().width_m),
        bound{{}, bounds(shape).centre(), 6} {}

  static GridTally made(const Field& field, const Polygon& shape, int tracks) {
    const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(31)));
    const double width_m = bounds(frame.to_track(shape.outer)).width() / tracks;
    return {frame,
            shape,
            {frame.to_track(classify_obstacles(field, 1).hard), {}, {}, {}},
            {width_m, 2 * width_m, end_criterion(EndRule::kCheapest, {}, width_m)}};
  }
  double origin() const { return tally.subfield().reach.min_x; }
};

void tally_by_corners(benchmark::State& state) {
  const OneGrid grid(large_field(static_cast<int>(state.range(0)), 0), kTracks);
  for (auto _ : state) benchmark::DoNotOptimize(grid.tally.at(grid.origin()));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(tally_by_corners)->RangeMultiplier(2)->Range(50, 1600)->Complexity()->Unit(benchmark::kMicrosecond);

void tally_by_tracks(benchmark::State& state) {
  const OneGrid grid(large_field(200, 0), static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(grid.tally.at(grid.origin()));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(tally_by_tracks)->RangeMultiplier(2)->Range(25, 800)->Complexity()->Unit(benchmark::kMicrosecond);

void tally_by_obstacles(benchmark::State& state) {
  const OneGrid grid(large_field(200, static_cast<int>(state.range(0))), kTracks);
  for (auto _ : state) benchmark::DoNotOptimize(grid.tally.at(grid.origin()));
}
BENCHMARK(tally_by_obstacles)->Arg(0)->Arg(2)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);

/// The same sum by polygon booleans, for the ratio.
void boolean_tally(benchmark::State& state) {
  const OneGrid grid(large_field(200, 0), kTracks);
  const TrackFrame& frame = grid.tally.subfield().frame;
  const TrackFamily strips = straight_tracks(grid.tally.grid(grid.origin()), grid.tally.subfield().shape,
                                             grid.tally.subfield().ground, grid.tally.terms().criterion);
  Region swaths;
  for (const LaidPiece& piece : cut_pieces(strips, grid.tally.terms().min_length_m).pieces) {
    const double left = strips.grid.line(piece.track), right = strips.grid.line(piece.track + 1);
    Ring ring;
    for (const Point corner :
         {Point{left, piece.from}, {right, piece.from}, {right, piece.to}, {left, piece.to}})
      ring.push_back(frame.to_field(corner));
    swaths.push_back({ring, {}});
  }
  for (auto _ : state) benchmark::DoNotOptimize(area(intersection(unite(swaths), {grid.shape})));
}
BENCHMARK(boolean_tally)->Unit(benchmark::kMicrosecond);

void bound_of_a_box(benchmark::State& state) {
  const OneGrid grid(large_field(static_cast<int>(state.range(0)), 0), kTracks);
  const GridBox box{grid.origin(), grid.width_m / 32, Angle::degrees(0.02).radians()};
  for (auto _ : state) benchmark::DoNotOptimize(least_cost(grid.tally, grid.bound, box));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(bound_of_a_box)->RangeMultiplier(2)->Range(50, 1600)->Complexity()->Unit(benchmark::kMicrosecond);

void best(benchmark::State& state, const Field& field, double width_m) {
  Machine machine;
  machine.width_m = width_m;
  const PlanningProblem problem{field, machine, {}, {}};
  const PreparedField prepared = field_without_headlands(problem);
  const SearchTask task(problem, prepared);
  SearchResult result;
  for (auto _ : state) result = best_search(task, SearchContext(1));
  state.counters["looked_at"] = result.directions_tried;
  state.counters["gap_one_direction_%"] =
      100 * gap(result.proof.one_direction_cost, result.proof.one_direction_bound);
}

/// The aims: 100 ms for up to 20 ha and 150 corners; 2 s for 25 ha, 1300 corners, 19 obstacles at w = 3.
void best_of_papers_field(benchmark::State& state) { best(state, papers_field(), 6); }
BENCHMARK(best_of_papers_field)->Unit(benchmark::kMillisecond);

void best_by_corners(benchmark::State& state) {
  best(state, large_field(static_cast<int>(state.range(0)), 0), 12);
}
BENCHMARK(best_by_corners)->Arg(25)->Arg(50)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);

void best_by_obstacles(benchmark::State& state) {
  best(state, large_field(100, static_cast<int>(state.range(0))), 12);
}
BENCHMARK(best_by_obstacles)->Arg(0)->Arg(1)->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);

void best_by_width(benchmark::State& state) {
  best(state, large_field(100, 0), static_cast<double>(state.range(0)));
}
BENCHMARK(best_by_width)->Arg(24)->Arg(12)->Arg(6)->Arg(3)->Unit(benchmark::kMillisecond);

/// 60 ha; half as wide for the same number of tracks as 25 ha at w = 3.
void best_of_large_field(benchmark::State& state) { best(state, large_field(1300, 19), 4.6); }
BENCHMARK(best_of_large_field)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace tramline::bench
