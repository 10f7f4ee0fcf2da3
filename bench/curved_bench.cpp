// What curved tracks cost (Zhou: 24.51 s for 30 ha at w = 2 m): one track, and a whole family from the
// reference line to the tally.

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>

#include "tramline/cost/strip_tally.h"
#include "tramline/cost/zhou_tally.h"
#include "tramline/geometry/path/extended_line.h"
#include "tramline/geometry/path/smoothed_line.h"
#include "tramline/model/objective.h"
#include "tramline/tracks/curved_tracks.h"
#include "tramline/tracks/zhou_tracks.h"

namespace tramline::bench {
namespace {

/// A winding line of about `elements` lines and arcs, a kilometre long whatever their number.
Path winding(int elements) {
  const int vertices = elements / 2 + 1;
  std::vector<Point> line;
  for (int i = 0; i <= vertices; ++i) {
    const double x = 1000.0 * i / vertices;
    line.push_back({x, 60 * std::sin(x / 150) + (i % 2 == 0 ? 0.4 : -0.4)});
  }
  return smoothed(line, 6, 0).path;
}

void one_parallel(benchmark::State& state) {
  const Path reference = winding(static_cast<int>(state.range(0)));
  const double offset = static_cast<double>(state.range(1));
  std::size_t tracks = 0;
  for (auto _ : state) tracks = parallel(reference, offset, {6, 2}).size();
  state.counters["elements"] = static_cast<double>(reference.size());
  state.counters["tracks"] = static_cast<double>(tracks);
}
BENCHMARK(one_parallel)->ArgsProduct({{60, 200, 1000}, {21, 101, 401}})->Unit(benchmark::kMicrosecond);

/// About 30 ha: 500 by 600 m with a winding western border of `vertices` points and two ponds.
Region field(int vertices) {
  Polygon out;
  for (int i = 0; i <= vertices; ++i) {
    const double y = 600.0 * i / vertices;
    out.outer.push_back({25 * std::sin(y / 90) + 8 * std::sin(y / 31), 600 - y});
  }
  out.outer.insert(out.outer.end(), {{180, -15}, {420, 10}, {510, 40}, {500, 380}, {460, 590}, {230, 615}});
  for (const Point at : {Point{170, 200}, Point{330, 420}}) {
    Ring pond;
    for (int i = 0; i < 12; ++i)
      pond.push_back(at + Point{14 * std::cos(0.5236 * i), 9 * std::sin(0.5236 * i)});
    out.holes.push_back(pond);
  }
  return {oriented(out)};
}

/// The western border of that field, northwards.
std::vector<Point> western_border(int vertices) {
  std::vector<Point> line;
  for (int i = vertices; i >= 0; --i) {
    const double y = 600.0 * i / vertices;
    line.push_back({25 * std::sin(y / 90) + 8 * std::sin(y / 31), 600 - y});
  }
  return line;
}

Tally family_to_tally(const std::vector<Point>& line, const Region& body, double width, EndRule rule,
                      double min_length) {
  const Path reference = extended(smoothed(line, 6, 0.1).path, bounds(body)).path;
  const StripRange range = tracks_over(reference, bounds(body), width);
  const LaidTracks tracks =
      curved_pieces(parallel_family(reference, range.first, range.last, {6, width}), width, {EdgeIndex(body)},
                    end_criterion(rule, Objective{}, width), min_length);
  return tally_of({}, {tracks}, area(body));
}

void count(benchmark::State& state, const Tally& tally) {
  state.counters["pieces"] = tally.pieces;
  state.counters["uncovered_m2"] = tally.uncovered_m2;
  state.counters["overlap_m2"] = tally.overlap_m2;
}

void whole_family(benchmark::State& state) {
  const int vertices = static_cast<int>(state.range(0));
  const Region body = field(vertices);
  const double width = static_cast<double>(state.range(1));
  const std::vector<Point> line = western_border(vertices);
  Tally tally;
  for (auto _ : state) {
    tally = family_to_tally(line, body, width, EndRule::kCheapest, 2 * width);
    benchmark::DoNotOptimize(tally);
  }
  state.counters["ha"] = 1e-4 * area(body);
  count(state, tally);
}
BENCHMARK(whole_family)->ArgsProduct({{30, 120}, {2, 4, 6}})->Unit(benchmark::kMillisecond);

/// The paper's end rule for both: everything is covered, no piece is too short.
void whole_family_covering(benchmark::State& state) {
  const Region body = field(60);
  Tally tally;
  for (auto _ : state) {
    tally =
        family_to_tally(western_border(60), body, static_cast<double>(state.range(0)), EndRule::kCover, 0);
    benchmark::DoNotOptimize(tally);
  }
  count(state, tally);
}
BENCHMARK(whole_family_covering)->Arg(4)->Arg(2)->Arg(1)->Unit(benchmark::kMillisecond);

/// The same map by Zhou's own construction, tracks and tally; `times_ours`: how many times as long as the
/// family above takes, measured in the same run.
void whole_family_as_in_the_paper(benchmark::State& state) {
  const Region body = field(60);
  const double width = static_cast<double>(state.range(0));
  const std::vector<Point> line = western_border(60);
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
  double paper_s = 0, ours_s = 0;
  Tally tally;
  for (auto _ : state) {
    const auto start = Clock::now();
    tally = zhou_tally(zhou_tracks(line, width, body, 0), width, body).tally;
    benchmark::DoNotOptimize(tally);
    paper_s += seconds(Clock::now() - start);
    state.PauseTiming();
    const auto ours = Clock::now();
    benchmark::DoNotOptimize(family_to_tally(line, body, width, EndRule::kCover, 0));
    ours_s += seconds(Clock::now() - ours);
    state.ResumeTiming();
  }
  count(state, tally);
  state.counters["times_ours"] = paper_s / ours_s;
}
BENCHMARK(whole_family_as_in_the_paper)->Arg(4)->Arg(2)->Arg(1)->Unit(benchmark::kMillisecond);

/// Without the tally, whose booleans Zhou does not need: it takes rows to be disjoint.
void tracks_alone_as_in_the_paper(benchmark::State& state) {
  const Region body = field(60);
  const double width = static_cast<double>(state.range(0));
  const std::vector<Point> line = western_border(60);
  for (auto _ : state) benchmark::DoNotOptimize(zhou_tracks(line, width, body, 0));
}
BENCHMARK(tracks_alone_as_in_the_paper)->Arg(4)->Arg(2)->Arg(1)->Unit(benchmark::kMillisecond);

void families_tracks_alone(benchmark::State& state) {
  const Region body = field(60);
  const Path reference = extended(smoothed(western_border(60), 6, 0.1).path, bounds(body)).path;
  const StripRange range = tracks_over(reference, bounds(body), 2);
  for (auto _ : state) benchmark::DoNotOptimize(parallel_family(reference, range.first, range.last, {6, 2}));
  state.counters["elements"] = static_cast<double>(reference.size());
  state.counters["tracks"] = range.last - range.first + 1;
}
BENCHMARK(families_tracks_alone)->Unit(benchmark::kMillisecond);

void smoothing_a_recorded_drive(benchmark::State& state) {
  std::vector<Point> line;
  unsigned noise = 1;
  for (int i = 0; i < 5000; ++i) {
    noise = noise * 1664525u + 1013904223u;
    line.push_back({0.4 * i, 60 * std::sin(0.4 * i / 120) + 0.05 * (noise / 4294967296.0 - 0.5)});
  }
  for (auto _ : state) benchmark::DoNotOptimize(smoothed(line, 6, 0.1));
}
BENCHMARK(smoothing_a_recorded_drive)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
