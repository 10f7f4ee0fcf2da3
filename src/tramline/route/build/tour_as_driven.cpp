#include "tramline/route/build/tour_as_driven.h"

#include <algorithm>
#include <utility>

#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

/// Ways of a tour that suppose another way before them than the machine takes to the line, and have no room
/// without: from one end, to another.
std::vector<std::pair<order::End, order::End>> supposed_in_vain(const TrackTour& tour,
                                                                const std::vector<RouteLine>& lines,
                                                                const BeforeLines& before,
                                                                const Connector& connector) {
  std::vector<std::pair<order::End, order::End>> out;
  if (std::ranges::none_of(tour.ways, &Way::supposed)) return out;
  SteeredPath left = before.left;
  for (std::size_t i = 0; i < tour.tour.size(); ++i) {
    const order::End entered = tour.tour[i];
    const DrivenSense& sense = lines[order::line_of(entered)].entered_by(entered);
    const Way& way = i > 0 ? tour.ways[i - 1] : before.way_to_first(entered, sense.first);
    if (way.supposed && !connector.between(left, sense.first).has_room())
      out.emplace_back(order::other_end(tour.tour[i - 1]), entered);
    left = driven_forward(left, way, sense.first);
    if (end_of(sense.first).at != end_of(sense.last).at) left = sense.last;
  }
  return out;
}

}  // namespace

Way way_on(const Way& found, const SteeredPath& left, const SteeredPath& entered,
           const Connector& connector) {
  if (found.has_room() && !found.supposed) return found;
  Way other = connector.between(left, entered);
  return other.has_room() || found.supposed ? other : found;
}

TrackTour best_tour_as_driven(const std::vector<order::Tour>& given, Senses senses, Patience patience,
                              const std::vector<RouteLine>& lines, const BeforeLines& before,
                              const Connector& connector, KnownCosts& costs) {
  TrackTour out = best_tour_with_ways(given, senses, patience, costs);
  for (int i = 0; i < kMostRefusals; ++i) {
    const auto in_vain = supposed_in_vain(out, lines, before, connector);
    if (in_vain.empty()) break;
    for (const auto& [left, entered] : in_vain) costs.refuse_supposed(left, entered);
    out = best_tour_with_ways(given, senses, patience, costs);
  }
  return out;
}

}  // namespace tramline
