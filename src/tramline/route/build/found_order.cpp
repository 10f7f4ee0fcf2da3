#include "tramline/route/build/found_order.h"

#include <algorithm>
#include <cassert>

#include "tramline/route/certificate/best_bound.h"
#include "tramline/route/search/best_order_exactly.h"
#include "tramline/route/search/first_tours.h"
#include "tramline/route/search/shortened.h"

namespace tramline::order {
namespace {

/// So many of the tours given are shortened, those that cost least, besides the greedy ones.
constexpr std::size_t kMostGiven = 2;
/// A search that goes on from a good tour makes a share of the usual number of kicks.
constexpr std::size_t kShareAgain = 12;
/// A tour that is proven to be so near to the best, as a share of its cost, is not searched on from: what
/// ways cost is only estimated.
constexpr double kNearBound = 3e-3;

/// The costs as bounds of themselves: their node prices say which lines are hard to reach.
class AsBounds final : public ConnectionBounds {
 public:
  explicit AsBounds(const EndCosts& costs) : costs_(costs) {}
  std::size_t lines() const override { return costs_.lines(); }
  std::size_t gates() const override { return 0; }
  double between(std::size_t a, std::size_t b) const override { return costs_.between(a, b); }
  double least(std::size_t a, std::size_t b) const override { return costs_.least(a, b); }

 private:
  const EndCosts& costs_;
};

void keep_cheapest(std::vector<Tour>& tours, const EndCosts& costs) {
  std::vector<std::pair<double, std::size_t>> by_cost;
  for (std::size_t i = 0; i < tours.size(); ++i) by_cost.emplace_back(connection_s(tours[i], costs), i);
  std::sort(by_cost.begin(), by_cost.end());
  std::vector<Tour> kept;
  for (const auto& [cost_s, i] : by_cost)
    if (kept.size() < kMostGiven) kept.push_back(std::move(tours[i]));
  tours = std::move(kept);
}

}  // namespace

Tour found_order(const EndCosts& costs, const Neighbours& neighbours, const std::vector<Tour>& given,
                 Effort effort) {
  assert(costs.lines() > 0);
  if (costs.lines() <= kMostLinesExactly) return best_order_exactly(costs);
  std::vector<Tour> tours = given;
  keep_cheapest(tours, costs);
  if (effort == Effort::kAgain && !tours.empty())
    return shortened(tours.front(), costs, neighbours, usual_kicks(costs.lines()) / kShareAgain);
  tours.push_back(greedy_tour(costs, neighbours));
  const double greedy_s = std::max(0.0, connection_s(tours.back(), costs));
  Tour improved = shortened(tours.back(), costs, neighbours, 0);
  const double near_s = (1 - kNearBound) * connection_s(improved, costs);
  const PricedBound priced = best_bound(AsBounds(costs), neighbours, {greedy_s, 0, greedy_s - near_s});
  if (priced.bound_s >= near_s) return improved;
  tours.push_back(greedy_tour(costs, neighbours, priced.prices_s));
  return shortened_best(tours, costs, neighbours, usual_kicks(costs.lines()));
}

}  // namespace tramline::order
