#include "tramline/route/build/found_order.h"

#include <algorithm>

#include "tramline/route/search/best_order_exactly.h"
#include "tramline/route/search/first_tours.h"
#include "tramline/route/search/shortened.h"

namespace tramline::order {
namespace {

/// So many tours are shortened, those that cost least.
constexpr std::size_t kMostShortened = 3;
/// A search that goes on from a good tour makes a share of the usual number of kicks.
constexpr std::size_t kShareAgain = 12;

void sort_by_cost(std::vector<Tour>& tours, const EndCosts& costs) {
  std::vector<std::pair<double, std::size_t>> by_cost;
  for (std::size_t i = 0; i < tours.size(); ++i) by_cost.emplace_back(connection_s(tours[i], costs), i);
  std::sort(by_cost.begin(), by_cost.end());
  std::vector<Tour> sorted;
  for (const auto& [cost_s, i] : by_cost) sorted.push_back(std::move(tours[i]));
  tours = std::move(sorted);
}

}  // namespace

Tour found_order(const EndCosts& costs, const Neighbours& neighbours, const std::vector<Tour>& given,
                 Effort effort) {
  if (costs.lines() <= kMostLinesExactly) return best_order_exactly(costs);
  std::vector<Tour> tours = given;
  if (effort == Effort::kWhole || tours.empty()) tours.push_back(greedy_tour(costs, neighbours));
  sort_by_cost(tours, costs);
  tours.resize(std::min(tours.size(), effort == Effort::kWhole ? kMostShortened : 1));
  const std::size_t kicks =
      usual_kicks(costs.lines()) / (effort == Effort::kWhole ? tours.size() : kShareAgain);
  for (Tour& tour : tours) tour = shortened(tour, costs, neighbours, kicks);
  sort_by_cost(tours, costs);
  return tours.front();
}

}  // namespace tramline::order
