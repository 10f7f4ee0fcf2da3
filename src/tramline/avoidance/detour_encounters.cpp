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
  const TrackFamily& family = family_of(decision);
  const Track& strip = strip_of(decision);
  const Interval between{strip.stretches[gap - 1].to, strip.stretches[gap].from};
  const double middle = 0.5 * (between.from + between.to);
  Encounter out;
  out.subfield = static_cast<int>(decision.track.subfield);
  out.track = strip.index;
  out.at = family.grid.frame.to_field({family.grid.centre(strip.index), middle});
  const std::size_t subfield = decision.track.subfield;
  out.obstacles =
      obstacles_along(subfield, hazards_in(family.grid, strip, between, around_[subfield]), between);
  for (const TrackDetour& detour : decision.chosen)
    if (detour.from <= middle && detour.to >= middle) {
      out.chosen = detour.side;
      const std::vector<int> taken_along = obstacles_taken_along(decision, detour);
      out.obstacles.insert(out.obstacles.end(), taken_along.begin(), taken_along.end());
      keep_common(out.obstacles, detour.obstacles);
      std::sort(out.obstacles.begin(), out.obstacles.end());
      out.obstacles.erase(std::unique(out.obstacles.begin(), out.obstacles.end()), out.obstacles.end());
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

/// A track simply ends at the headland round an obstacle, and there is nothing to decide. Where a detour
/// about another obstacle leads past it all the same, it is met with that one.
std::vector<int> DetourDecisions::obstacles_taken_along(const Decision& decision,
                                                        const TrackDetour& detour) const {
  const TrackFamily& family = family_of(decision);
  const Track& strip = strip_of(decision);
  const std::size_t subfield = decision.track.subfield;
  const std::vector<std::size_t>& decided = decision.track.gaps;
  std::vector<int> out;
  for (std::size_t gap = 1; gap < strip.stretches.size(); ++gap) {
    const Interval between{strip.stretches[gap - 1].to, strip.stretches[gap].from};
    const bool inside = detour.from <= between.from && detour.to >= between.to;
    if (!inside || std::find(decided.begin(), decided.end(), gap) != decided.end()) continue;
    const std::vector<int> there =
        obstacles_along(subfield, hazards_in(family.grid, strip, between, around_[subfield]), between);
    out.insert(out.end(), there.begin(), there.end());
  }
  return out;
}

}  // namespace tramline
