// What was decided where tracks meet obstacles, and what the other ways would have cost.

#include <algorithm>

#include "tramline/avoidance/detour_decisions.h"

namespace tramline {
namespace {

/// Of two ascending lists.
void keep_common(std::vector<int>& some, const std::vector<int>& others) {
  std::erase_if(some, [&](int x) { return !std::binary_search(others.begin(), others.end(), x); });
}

}  // namespace

std::vector<Encounter> DetourDecisions::encounters() {
  std::vector<Encounter> out;
  for (Decision& decision : tracks_) {
    value(decision);
    for (const std::size_t gap : decision.track.gaps) out.push_back(encounter_at(decision, gap));
  }
  return out;
}

Encounter DetourDecisions::encounter_at(Decision& decision, std::size_t gap) {
  const Strips& strips = strips_of(decision);
  const Strip& strip = strip_of(decision);
  const Interval between{strip.stretches[gap - 1].to, strip.stretches[gap].from};
  const double middle = 0.5 * (between.from + between.to);
  Encounter out;
  out.subfield = static_cast<int>(decision.track.subfield);
  out.track = strip.index;
  out.at = strips.grid.frame.to_field({strips.grid.centre(strip.index), middle});
  const std::size_t subfield = decision.track.subfield;
  out.obstacles =
      obstacles_along(subfield, hazards_in(strips.grid, strip, between, around_[subfield]), between);
  for (const StripDetour& detour : decision.chosen)
    if (detour.from <= middle && detour.to >= middle) {
      out.chosen = detour.side;
      keep_common(out.obstacles, detour.obstacles);
    }
  const auto choice = [&](Passing side) {
    return cheapest_choice(decision.track, strip, width_m_, task_.objective, least_m_, Forced{gap, side});
  };
  const double cost_of_cut = choice(Passing::kCut)->cost;
  const auto past = [&](Passing side) {
    return way_past(decision.track, {gap, side}, choice(side), cost_of_cut, "S1 passes on the other side");
  };
  out.left = past(Passing::kLeft);
  out.right = past(Passing::kRight);
  return out;
}

}  // namespace tramline
