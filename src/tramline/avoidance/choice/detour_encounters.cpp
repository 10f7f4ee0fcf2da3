// The decisions where tracks meet obstacles, and the costs of the other ways.

#include <algorithm>

#include "tramline/avoidance/choice/detour_decisions.h"

namespace tramline {
namespace {

/// Keeps the elements common to two ascending lists.
void keep_common(std::vector<std::size_t>& some, const std::vector<std::size_t>& others) {
  std::erase_if(some, [&](std::size_t x) { return !std::binary_search(others.begin(), others.end(), x); });
}

/// The point on the line of a track, in the field's frame.
Point point_on(const TrackFamily& family, const Track& track, double along) {
  if (is_straight(track)) return family.grid.frame.to_field({family.grid.centre(track.index), along});
  return path_along(track, 0, along).back().to;
}

}  // namespace

std::vector<PlacedEncounter> DetourDecisions::encounters() {
  std::vector<PlacedEncounter> out;
  for (Decision& decision : tracks_) {
    value(decision);
    for (const std::size_t gap : decision.track.gaps) out.push_back(encounter_at(decision, gap));
  }
  return out;
}

PlacedEncounter DetourDecisions::encounter_at(Decision& decision, std::size_t gap) {
  const Track& track = track_of(decision);
  PlacedEncounter out;
  out.between = {track.stretches[gap - 1].to, track.stretches[gap].from};
  const double middle = 0.5 * (out.between.from + out.between.to);
  out.subfield = decision.track.family;
  out.track = track.index;
  out.branch = track.branch;
  out.at = point_on(family_of(decision), track, middle);
  out.obstacles = obstacles_in(decision.track, out.between);
  for (const TrackDetour& detour : decision.chosen)
    if (detour.from <= middle && detour.to >= middle) {
      out.chosen = detour.side;
      const std::vector<std::size_t> passed = obstacles_passed_with(decision, detour);
      out.obstacles.insert(out.obstacles.end(), passed.begin(), passed.end());
      keep_common(out.obstacles, detour.obstacles);
      std::sort(out.obstacles.begin(), out.obstacles.end());
      out.obstacles.erase(std::unique(out.obstacles.begin(), out.obstacles.end()), out.obstacles.end());
    }
  const auto choice = [&](Passing side) {
    return cheapest_choice(decision.track, track, width_m_, task_.objective, least_m_, Forced{gap, side});
  };
  const double cost_of_cut = choice(Passing::kCut)->cost;
  const auto past = [&](Passing side) {
    return way_past(decision.track, {gap, side}, choice(side), cost_of_cut, ways_);
  };
  out.left = past(Passing::kLeft);
  out.right = past(Passing::kRight);
  return out;
}

/// At the headland round an obstacle a track just ends, and there is nothing to decide. Where a detour round
/// another obstacle leads past it all the same, it counts to that encounter.
std::vector<std::size_t> DetourDecisions::obstacles_passed_with(const Decision& decision,
                                                                const TrackDetour& detour) const {
  const Track& track = track_of(decision);
  const std::vector<std::size_t>& decided = decision.track.gaps;
  std::vector<std::size_t> out;
  for (std::size_t gap = 1; gap < track.stretches.size(); ++gap) {
    const Interval between{track.stretches[gap - 1].to, track.stretches[gap].from};
    const bool inside = detour.from <= between.from && detour.to >= between.to;
    if (!inside || std::find(decided.begin(), decided.end(), gap) != decided.end()) continue;
    const std::vector<std::size_t> there = obstacles_in(decision.track, between);
    out.insert(out.end(), there.begin(), there.end());
  }
  return out;
}

}  // namespace tramline
