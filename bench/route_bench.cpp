// The order of lines over a field, and the bound that proves it: up to a thousand lines, connected by Dubins
// ways.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "tramline/route/certificate/best_bound.h"
#include "tramline/route/certificate/priced_bound.h"
#include "tramline/route/search/best_order_exactly.h"
#include "tramline/route/search/first_tours.h"
#include "tramline/route/search/shortened.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline::bench {
namespace {

using order::End;

constexpr double kWidth_m = 6;
constexpr double kRadius_m = 6;
constexpr double kSpeed_m_s = 2;

/// Tracks over a field whose edges run in waves, and of every tenth track two pieces, with a pond between.
class WavyField final : public order::EndCosts, public order::ConnectionBounds {
 public:
  explicit WavyField(std::size_t lines) {
    std::mt19937 random(static_cast<unsigned>(lines));
    for (double x = 0; leaving_.size() < 2 * lines; x += kWidth_m) {
      const double foot = 40 * std::sin(x / 90), head = 250 + 60 * std::sin(x / 140);
      const bool pond = random() % 10 == 0 && leaving_.size() + 2 < 2 * lines;
      if (pond) {
        add({x, foot}, {x, foot + 90});
        add({x, foot + 120}, {x, head});
      } else {
        add({x, foot}, {x, head});
      }
    }
  }

  std::size_t lines() const override { return leaving_.size() / 2; }
  std::size_t gates() const override { return 0; }
  double between(std::size_t a, std::size_t b) const override {
    const Pose entering{leaving_[b].at, leaving_[order::other_end(b)].heading};
    return dubins_length(leaving_[a], entering, kRadius_m) / kSpeed_m_s;
  }
  double least(std::size_t a, std::size_t b) const override {
    const Point way = leaving_[b].at - leaving_[a].at;
    return std::sqrt(dot(way, way)) / kSpeed_m_s;
  }
  order::Neighbours neighbours() const {
    return order::neighbours_of(
        2 * lines(), [this](auto a, auto b) { return least(a, b); },
        [this](auto a, auto b) { return between(a, b); });
  }

 private:
  void add(Point start, Point end) {
    leaving_.push_back({start, Heading::from_to(end, start)});
    leaving_.push_back({end, Heading::from_to(start, end)});
  }

  std::vector<Pose> leaving_;  ///< by end
};

std::size_t lines_of_run(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

void order_exactly(benchmark::State& state) {
  const WavyField field(lines_of_run(state));
  for (auto _ : state) benchmark::DoNotOptimize(order::best_order_exactly(field));
}
BENCHMARK(order_exactly)->Arg(8)->Arg(11)->Unit(benchmark::kMillisecond);

void neighbours_and_greedy_tour(benchmark::State& state) {
  const WavyField field(lines_of_run(state));
  for (auto _ : state) benchmark::DoNotOptimize(order::greedy_tour(field, field.neighbours()));
}
BENCHMARK(neighbours_and_greedy_tour)->Arg(150)->Arg(377)->Arg(1000)->Unit(benchmark::kMillisecond);

void search_for_the_order(benchmark::State& state) {
  const WavyField field(lines_of_run(state));
  const order::Neighbours near = field.neighbours();
  const order::Tour first = order::greedy_tour(field, near);
  double found_s = 0;
  for (auto _ : state)
    found_s = connection_s(order::shortened(first, field, near, order::usual_kicks(field.lines())), field);
  state.counters["saved_percent"] = 100 * (1 - found_s / connection_s(first, field));
}
BENCHMARK(search_for_the_order)->Arg(40)->Arg(150)->Arg(377)->Arg(1000)->Unit(benchmark::kMillisecond);

void bound_of_the_route(benchmark::State& state) {
  const WavyField field(lines_of_run(state));
  const order::Neighbours near = field.neighbours();
  const order::Tour tour =
      order::shortened(order::greedy_tour(field, near), field, near, order::usual_kicks(field.lines()));
  const double known_s = connection_s(tour, field);
  order::PricedBound bound;
  for (auto _ : state) bound = order::best_bound(field, {known_s, 0});
  state.counters["gap_percent"] = 100 * (1 - bound.bound_s / known_s);
}
BENCHMARK(bound_of_the_route)->Arg(40)->Arg(150)->Arg(377)->Arg(1000)->Unit(benchmark::kMillisecond);

void bound_of_given_prices(benchmark::State& state) {
  const WavyField field(lines_of_run(state));
  const std::vector<double> prices(field.nodes(), 0);
  for (auto _ : state) benchmark::DoNotOptimize(order::bound_of_pruned(prices, field));
}
BENCHMARK(bound_of_given_prices)->Arg(377)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tramline::bench
