#pragma once
// The order of the tracks and the ways between them.

#include <vector>

#include "tramline/route/build/known_costs.h"
#include "tramline/route/build/patience.h"

namespace tramline {

/// A tour over lines and the ways between them, one fewer than lines.
struct TrackTour {
  order::Tour tour;
  std::vector<Way> ways;
  bool gave_up = false;  ///< with more patience another might have been found
};

/// Whether a way costs as much as the same one driven from its end, as it does where nothing reaches ahead of
/// the axle or behind it. Ways are found by a search that begins at one end, so those of the other sense may
/// differ by a little all the same.
enum class Senses { kCostTheSame, kDiffer };

/// The ways of a given tour, as it is or, where that costs less, driven from its end.
TrackTour with_ways(const order::Tour& tour, Senses senses, KnownCosts& costs);

/// A tour of little cost: up to kMostExact lines the best, otherwise the best found from the tours given and
/// from others, by exchanges. Costs are lower bounds where no way has been looked for, so ways are looked for
/// along the best tour, those to its first line and from its last too, and the search is repeated from there
/// until it stays or `patience` ends; the best tour whose ways are known is returned. Deterministic.
TrackTour best_tour_with_ways(const std::vector<order::Tour>& given, Senses senses, Patience patience,
                              KnownCosts& costs);

}  // namespace tramline
