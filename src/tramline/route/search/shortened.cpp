#include "tramline/route/search/shortened.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include "tramline/route/search/closed_tour.h"
#include "tramline/route/search/double_bridge.h"
#include "tramline/route/search/local_search.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

/// From one connection to another that a kick changes with it.
constexpr std::size_t kSteps = 6;
/// By how much a tour may be worse than the best one at first, in connections.
constexpr double kTolerated = 2;

/// Those of the ends of the lines, and for the ends of the outside the ends of least cost.
Neighbours with_outside(Neighbours neighbours, const EndCosts& costs) {
  const std::size_t ends = neighbours.size();
  std::size_t kept = 0;
  for (const std::vector<End>& near : neighbours) kept = std::max(kept, near.size());
  const auto nearest = [&](auto cost) {
    std::vector<std::pair<double, End>> rated;
    for (End end = 0; end < ends; ++end) rated.emplace_back(cost(end), end);
    const auto last = rated.begin() + static_cast<std::ptrdiff_t>(std::min(kept, ends));
    std::partial_sort(rated.begin(), last, rated.end());
    std::vector<End> out;
    for (auto one = rated.begin(); one != last; ++one) out.push_back(one->second);
    return out;
  };
  std::vector<End> finish = nearest([&](End end) { return costs.at_finish(end); });
  std::vector<End> start = nearest([&](End end) { return costs.at_start(end); });
  neighbours.push_back(std::move(finish));
  neighbours.push_back(std::move(start));
  return neighbours;
}

/// The same numbers on every machine, unlike those of the distributions of the standard library.
std::size_t below(std::size_t limit, std::mt19937& random) {
  return static_cast<std::size_t>((static_cast<std::uint64_t>(random()) * limit) >> 32U);
}

/// A line a few steps away from the line of this end, from one end to one of those near it and so on.
std::size_t walked_place(End from, const ClosedTour& tour, const Neighbours& near, std::mt19937& random) {
  End at = from;
  for (std::size_t step = 0; step < kSteps && !near[at].empty(); ++step) {
    at = near[at][below(near[at].size(), random)];
    if (below(2, random) == 0) at = other_end(at);
  }
  return tour.place(at);
}

/// Of four connections near one another (the random walk kick of Applegate, Cook and Rohe 2003).
DoubleBridge random_kick(const ClosedTour& tour, const Neighbours& near, std::mt19937& random) {
  const End from = below(2 * tour.lines(), random);
  std::array<std::size_t, 4> places{tour.place(from)};
  for (std::size_t i = 1; i < places.size(); ++i) places[i] = walked_place(from, tour, near, random);
  std::sort(places.begin(), places.end());
  return {tour.next(places[0]), {places[1] - places[0], places[2] - places[1], places[3] - places[2]}};
}

/// A tour that is kicked again and again, and the best one seen.
class KickedTour {
 public:
  KickedTour(ClosedTour& ring, LocalSearch& search, const Neighbours& near)
      : ring_(ring), search_(search), near_(near), best_(ring.open()) {}

  /// The tour may be a little worse than the best one meanwhile, by less and less (record-to-record travel of
  /// Dueck 1993).
  Tour kick(std::size_t kicks, double tolerated_s) {
    for (std::size_t i = 0; i < kicks; ++i)
      kick_once(tolerated_s * static_cast<double>(kicks - i) / static_cast<double>(kicks));
    return best_;
  }

 private:
  void kick_once(double tolerated_s) {
    ring_.keep();
    const DoubleBridge kick = random_kick(ring_, near_, random_);
    if (!kick.is_valid(ring_)) return;
    double change_s = -kick.gain(ring_);
    kick.apply(ring_);
    for (const End changed : ring_.changed_since(0)) search_.wait(changed);
    change_s -= search_.run();
    if (above_s_ + change_s > tolerated_s) {
      ring_.undo_to(0);
      return;
    }
    above_s_ += change_s;
    if (above_s_ >= -kSameTime_s) return;
    best_ = ring_.open();
    above_s_ = 0;
  }

  ClosedTour& ring_;
  LocalSearch& search_;
  const Neighbours& near_;
  std::mt19937 random_;  // NOLINT(bugprone-random-generator-seed): the same kicks every time
  Tour best_;
  double above_s_ = 0;  ///< how much the tour costs more than the best one
};

}  // namespace

std::size_t usual_kicks(std::size_t lines) { return std::max<std::size_t>(500, 4 * lines); }

Tour shortened(const Tour& tour, const EndCosts& costs, const Neighbours& neighbours, std::size_t kicks) {
  assert(tour.size() == costs.lines() && neighbours.size() == 2 * tour.size());
  if (tour.size() < 2) return tour;
  ClosedCosts closed(costs);
  ClosedTour ring(tour, closed);
  const Neighbours near = with_outside(neighbours, costs);
  LocalSearch search(ring, near);
  for (const End entered : tour) search.wait(entered);
  search.wait(ring.start());
  search.run();
  const double mean_s = connection_s(ring.open(), costs) / static_cast<double>(tour.size());
  return KickedTour(ring, search, near).kick(kicks, kTolerated * mean_s);
}

Tour shortened_best(const std::vector<Tour>& tours, const EndCosts& costs, const Neighbours& neighbours,
                    std::size_t kicks) {
  assert(!tours.empty());
  Tour best;
  double least_s = std::numeric_limits<double>::infinity();
  for (const Tour& tour : tours) {
    Tour found = shortened(tour, costs, neighbours, kicks / (2 * tours.size()));
    const double cost_s = connection_s(found, costs);
    if (cost_s >= least_s) continue;
    least_s = cost_s;
    best = std::move(found);
  }
  return shortened(best, costs, neighbours, kicks - kicks / 2);
}

}  // namespace tramline::order
