#include "tramline/route/build/track_tour.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tramline/route/build/found_order.h"
#include "tramline/route/tolerances.h"

namespace tramline {
namespace {

/// Ways along the best tour are looked for so often, and many more times as long as some of them lack room:
/// of a dozen lines in narrow land few orders have it. Where ways have to be searched for they take long:
/// there so many tours that are no better are enough.
constexpr int kMostRounds = 10, kMostForRoom = 48, kPatience = 5;
/// The same with Patience::kLong, of tours of any kind.
constexpr int kMostRoundsLong = 60;
/// Where the first tour costs so many times as much as foreseen, ways are expected to cost more.
constexpr double kFarMore = 1.3;
/// What was foreseen of a tour is near enough, as a share of it; and tours that are foreseen to cost less by
/// no larger a share are not looked at.
constexpr double kForeseen = 1e-3;

using order::Tour;

double cost_of_ways(const std::vector<Way>& ways) {
  double out = 0;
  for (const Way& way : ways) out += way.cost_s;
  return out;
}

TrackTour in_order(const Tour& tour, KnownCosts& costs) {
  TrackTour out;
  out.tour = tour;
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

/// The same with the way to the first line.
std::ptrdiff_t without_room(const TrackTour& tour, const KnownCosts& costs) {
  return without_room(tour.ways) + (costs.starts_with_room(tour.tour.front()) ? 0 : 1);
}

double at_ends(const Tour& tour, const KnownCosts& costs) {
  return costs.at_start(tour.front()) + costs.at_finish(order::other_end(tour.back()));
}

double whole_cost(const TrackTour& tour, const KnownCosts& costs) {
  return cost_of_ways(tour.ways) + at_ends(tour.tour, costs);
}

/// The rounds of a search in which the best tour so far lacks room or has it.
int most_rounds(Patience patience, bool lacks_room) {
  if (patience == Patience::kLong) return kMostRoundsLong;
  return lacks_room ? kMostForRoom : kMostRounds;
}

/// Of tours whose ways are known the one with the fewest ways without room, and of these the quickest: on
/// land on which some way has none, how much is missing there decides nothing.
Tour best_settled(const std::vector<Tour>& tours, KnownCosts& costs) {
  const auto rank = [&](const Tour& tour) {
    std::ptrdiff_t lacking = costs.starts_with_room(tour.front()) ? 0 : 1;
    double ways_s = 0;
    for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
      const Way& way = costs.way(order::other_end(tour[i]), tour[i + 1]);
      ways_s += way.cost_s;
      if (!way.has_room()) ++lacking;
    }
    return std::pair(lacking,
                     lacking == 0 ? order::connection_s(tour, costs) : ways_s + at_ends(tour, costs));
  };
  return *std::ranges::min_element(tours, {}, rank);
}

}  // namespace

TrackTour with_ways(const Tour& tour, Senses senses, KnownCosts& costs) {
  Tour first = tour, second = order::backwards(tour);
  settle_ends(first, costs);
  settle_ends(second, costs);
  if (senses == Senses::kCostTheSame && at_ends(second, costs) < at_ends(first, costs))
    std::swap(first, second);
  TrackTour there = in_order(first, costs);
  const auto lacking = without_room(there, costs);
  if (senses == Senses::kCostTheSame && lacking == 0) return there;
  TrackTour back = in_order(second, costs);
  const auto lacking_back = without_room(back, costs);
  if (lacking != lacking_back) return lacking < lacking_back ? there : back;
  return whole_cost(there, costs) <= whole_cost(back, costs) ? there : back;
}

TrackTour best_tour_with_ways(const std::vector<Tour>& given, Senses senses, Patience patience,
                              KnownCosts& costs) {
  std::vector<Tour> settled;
  Tour tour = found_order(costs, costs.neighbours(), given, order::Effort::kWhole);
  double least_s = std::numeric_limits<double>::infinity();
  std::ptrdiff_t lacking = 0;  // ways of the best tour
  bool shallow = false;        // headlands, for many turns
  bool stays = false;
  for (int round = 0, idle = 0; round < most_rounds(patience, lacking > 0); ++round) {
    const double foreseen_s = order::connection_s(tour, costs);
    stays = lacking == 0 && foreseen_s >= (1 - kForeseen) * least_s;
    if (stays) break;
    const TrackTour found = in_order(tour, costs);
    settle_ends(tour, costs);
    settled.push_back(tour);
    const double cost_s = order::connection_s(tour, costs);
    stays = cost_s <= (1 + kForeseen) * foreseen_s + kLeastGain_s;
    if (stays) break;
    if (round == 0 && cost_s > kFarMore * foreseen_s) {
      shallow = true;
      costs.expect_more();
    }
    if (cost_s < least_s) {
      least_s = cost_s;
      lacking = without_room(found, costs);
      idle = 0;
    } else if (++idle >= kPatience && lacking == 0 && shallow && patience == Patience::kUsual) {
      break;
    }
    tour = found_order(costs, costs.neighbours(), settled, order::Effort::kAgain);
  }
  TrackTour out = with_ways(best_settled(settled, costs), senses, costs);
  out.gave_up = !stays;
  return out;
}

}  // namespace tramline
