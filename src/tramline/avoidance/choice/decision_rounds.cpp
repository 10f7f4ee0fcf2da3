#include "tramline/avoidance/choice/decision_rounds.h"

#include <algorithm>
#include <utility>

#include "tramline/avoidance/tolerances.h"

namespace tramline {

std::vector<Decision*> by_saving(std::vector<Decision>& decisions, const SavingOf& saving_of) {
  std::vector<std::pair<double, Decision*>> savings;
  for (Decision& decision : decisions) savings.emplace_back(saving_of(decision, nullptr), &decision);
  std::stable_sort(savings.begin(), savings.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Decision*> out;
  for (const auto& [saving, decision] : savings) out.push_back(decision);
  return out;
}

bool improve_one_by_one(const std::vector<Decision*>& order, const SavingOf& saving_of,
                        const Choose& choose) {
  bool any = false;
  for (bool first_round = true, changed = true; changed; first_round = false) {
    changed = false;
    for (Decision* decision : order) {
      if (!first_round && !decision->track.stale) continue;
      std::vector<TrackDetour> detours;
      if (saving_of(*decision, &detours) <= kRounding_cost) continue;
      choose(*decision, std::move(detours));
      changed = true;
    }
    any = any || changed;
  }
  return any;
}

}  // namespace tramline
