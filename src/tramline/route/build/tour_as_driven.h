#pragma once
// Orders of lines whose ways hold as the machine comes to each line.

#include <functional>
#include <vector>

#include "tramline/route/build/track_tour.h"

namespace tramline {

/// Where a route is before it works lines.
struct BeforeLines {
  SteeredPath left;  ///< what was driven forward to the end of the work so far; empty at the beginning
  /// The way to the first line, and over that.
  std::function<Way(order::End entered, const SteeredPath& axle)> way_to_first;
};

/// The way that was found between two works, of which `left` is what was driven forward to the end of the
/// first in fact. Where it has no room, or supposes a way to the first of them (Way::supposed), one that
/// backs along what was driven, which was not known when it was looked for.
Way way_on(const Way& found, const SteeredPath& left, const SteeredPath& entered, const Connector& connector);

/// A tour of little cost (see best_tour_with_ways) of which no way supposes another way to the line before it
/// than the machine takes, where that leaves it no room. Such ways are refused and a tour is looked for anew,
/// kMostRefusals times at most. Deterministic.
TrackTour best_tour_as_driven(const std::vector<order::Tour>& given, Senses senses, Patience patience,
                              const std::vector<RouteLine>& lines, const BeforeLines& before,
                              const Connector& connector, KnownCosts& costs);

inline constexpr int kMostRefusals = 12;

}  // namespace tramline
