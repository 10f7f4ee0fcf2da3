#include "tramline/route/build/track_tour.h"

#include <algorithm>
#include <utility>

#include "tramline/route/build/found_order.h"
#include "tramline/route/tolerances.h"

namespace tramline {
namespace {

/// Ways along the best tour are looked for so often.
constexpr int kMostRounds = 10;
/// What was foreseen of a tour is near enough, as a share of it.
constexpr double kForeseen = 1e-3;

using order::Tour;

double cost_of_ways(const std::vector<Way>& ways) {
  double out = 0;
  for (const Way& way : ways) out += way.cost_s;
  return out;
}

TrackTour in_order(const Tour& tour, KnownCosts& costs) {
  TrackTour out{tour, {}};
  for (std::size_t i = 0; i + 1 < tour.size(); ++i)
    out.ways.push_back(costs.way(order::other_end(tour[i]), tour[i + 1]));
  return out;
}

void settle_ends(const Tour& tour, KnownCosts& costs) {
  costs.settle_start(tour.front());
  costs.settle_finish(order::other_end(tour.back()));
}

auto without_room(const std::vector<Way>& ways) {
  return std::ranges::count_if(ways, [](const Way& way) { return !way.has_room(); });
}

double at_ends(const Tour& tour, const KnownCosts& costs) {
  return costs.at_start(tour.front()) + costs.at_finish(order::other_end(tour.back()));
}

double whole_cost(const TrackTour& tour, const KnownCosts& costs) {
  return cost_of_ways(tour.ways) + at_ends(tour.tour, costs);
}

/// The cheapest of tours by what is known of them.
const Tour& cheapest(const std::vector<Tour>& tours, const KnownCosts& costs) {
  return *std::ranges::min_element(tours, {},
                                   [&](const Tour& tour) { return order::connection_s(tour, costs); });
}

}  // namespace

TrackTour with_ways(const Tour& tour, Senses senses, KnownCosts& costs) {
  Tour first = tour, second = order::backwards(tour);
  settle_ends(first, costs);
  settle_ends(second, costs);
  if (senses == Senses::kCostTheSame && at_ends(second, costs) < at_ends(first, costs))
    std::swap(first, second);
  TrackTour there = in_order(first, costs);
  const auto lacking = without_room(there.ways);
  if (senses == Senses::kCostTheSame && lacking == 0) return there;
  TrackTour back = in_order(second, costs);
  const auto lacking_back = without_room(back.ways);
  if (lacking != lacking_back) return lacking < lacking_back ? there : back;
  return whole_cost(there, costs) <= whole_cost(back, costs) ? there : back;
}

TrackTour best_tour_with_ways(const std::vector<Tour>& given, Senses senses, KnownCosts& costs) {
  const order::Neighbours neighbours = costs.neighbours();
  std::vector<Tour> settled;
  Tour tour = found_order(costs, neighbours, given, order::Effort::kWhole);
  for (int round = 0; round < kMostRounds; ++round) {
    const double foreseen_s = order::connection_s(tour, costs);
    in_order(tour, costs);
    settle_ends(tour, costs);
    settled.push_back(tour);
    if (order::connection_s(tour, costs) <= (1 + kForeseen) * foreseen_s + kLeastGain_s) break;
    tour = found_order(costs, neighbours, settled, order::Effort::kAgain);
  }
  return with_ways(cheapest(settled, costs), senses, costs);
}

}  // namespace tramline
