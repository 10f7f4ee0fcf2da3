// The value of each choice while the others stay, and the search for better choices.

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "tramline/avoidance/choice/detour_decisions.h"
#include "tramline/avoidance/tolerances.h"

namespace tramline {
namespace {

constexpr std::size_t kMostTogether = 4;  ///< tracks whose choices are tried with one another

bool share_a_hazard(const BlockedTrack& a, const BlockedTrack& b) {
  for (const TrackOption& mine : a.options)
    for (const TrackOption& theirs : b.options)
      for (const std::size_t hazard : mine.way.hazards)
        if (std::find(theirs.way.hazards.begin(), theirs.way.hazards.end(), hazard) !=
            theirs.way.hazards.end())
          return true;
  return false;
}

/// What the best choice for a track saves against its present one; also gives that choice where `best` is not
/// null.
using SavingOf = std::function<double(Decision&, std::vector<TrackDetour>* best)>;
using Choose = std::function<void(Decision&, std::vector<TrackDetour> detours)>;

/// The decisions that save most come first: an order that does not depend on how the field lies in its frame.
std::vector<Decision*> by_saving(std::vector<Decision>& decisions, const SavingOf& saving_of) {
  std::vector<std::pair<double, Decision*>> savings;
  for (Decision& decision : decisions) savings.emplace_back(saving_of(decision, nullptr), &decision);
  std::stable_sort(savings.begin(), savings.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Decision*> out;
  for (const auto& [saving, decision] : savings) out.push_back(decision);
  return out;
}

/// Gives every track in this order its best choice while the others stay, and repeats this for stale tracks
/// until none changes. Every change saves, so the rounds come to an end. False where nothing changed.
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

}  // namespace

void DetourDecisions::value(Decision& decision) {
  const TrackWork& own = ground_.at(decision.track.family, decision.track.place);
  const int here = driven_[decision.track.family] - (is_driven(own) ? 1 : 0);
  const bool elsewhere = std::accumulate(driven_.begin(), driven_.end(), 0) > driven_[decision.track.family];
  decision.track.only_one_driven = here == 0 && !elsewhere;
  decision.track.only_one_of_subfield = here == 0 && elsewhere;
  value_options(decision.track, family_of(decision), body_[decision.track.family], ground_, least_m_);
}

/// What the track's best choice saves against its present one.
double DetourDecisions::saving_of(Decision& decision, std::vector<TrackDetour>* best_detours) {
  value(decision);
  const Track& track = track_of(decision);
  const auto best = cheapest_choice(decision.track, track, width_m_, task_.objective, least_m_);
  if (!best || same_detours(best->detours, decision.chosen)) return 0;
  if (best_detours != nullptr) *best_detours = best->detours;
  return track_cost(decision.track, track, width_m_, decision.chosen, task_.objective, least_m_) - best->cost;
}

bool DetourDecisions::improve() {
  const auto saving = [this](Decision& decision, std::vector<TrackDetour>* best) {
    return saving_of(decision, best);
  };
  const auto chosen = [this](Decision& decision, std::vector<TrackDetour> detours) {
    choose(decision, std::move(detours));
  };
  const std::vector<Decision*> order = by_saving(tracks_, saving);
  const bool singly = improve_one_by_one(order, saving, chosen);
  if (!improve_groups()) return singly;
  improve_one_by_one(order, saving, chosen);
  return true;
}

/// For a pole on the line between tracks: the best choices of single tracks need not be the best combination.
bool DetourDecisions::improve_groups() {
  const auto one_pole = [this](std::size_t i, std::size_t j) {
    const BlockedTrack &a = tracks_[i].track, &b = tracks_[j].track;
    return a.family == b.family && b.place == a.place + 1 && a.gaps.size() == 1 && b.gaps.size() == 1 &&
           share_a_hazard(a, b);
  };
  bool any = false;
  for (std::size_t first = 0; first < tracks_.size();) {
    std::size_t end = first + 1;
    while (end < tracks_.size() && one_pole(end - 1, end)) ++end;
    if (end - first > 1 && end - first <= kMostTogether) any = improve_group(first, end) || any;
    first = end;
  }
  return any;
}

/// Tries every choice for all tracks of the group but the last, with the best one for that.
bool DetourDecisions::improve_group(std::size_t first, std::size_t end) {
  Group group{first, end, {}, kRounding_cost};
  try_choices(group, first, 0);
  if (group.best.empty()) return false;
  for (std::size_t i = first; i < end; ++i) choose(tracks_[i], std::move(group.best[i - first]));
  return true;
}

/// Tries the tracks from `at` on; those before hold the choices being tried, which together save `saved`.
/// Leaves all tracks from `at` on as they were.
void DetourDecisions::try_choices(Group& group, std::size_t at, double saved) {
  Decision& decision = tracks_[at];
  const std::vector<TrackDetour> now = decision.chosen;
  const auto cost_of = [&](const std::vector<TrackDetour>& detours) {
    return track_cost(decision.track, track_of(decision), width_m_, detours, task_.objective, least_m_);
  };
  value(decision);
  const double cost_now = cost_of(now);
  if (at + 1 == group.end) {
    const auto answer =
        cheapest_choice(decision.track, track_of(decision), width_m_, task_.objective, least_m_);
    if (!answer || saved + cost_now - answer->cost <= group.most_saved) return;
    group.most_saved = saved + cost_now - answer->cost;
    group.best.clear();
    for (std::size_t i = group.first; i < at; ++i) group.best.push_back(tracks_[i].chosen);
    group.best.push_back(answer->detours);
    return;
  }
  std::vector<std::pair<std::vector<TrackDetour>, double>> choices{{{}, 0}};
  for (const TrackOption& option : decision.track.options) choices.push_back({{option.way.detour}, 0});
  for (auto& [detours, cost] : choices) cost = cost_of(detours);
  for (auto& [detours, cost] : choices) {
    choose(decision, std::move(detours));
    try_choices(group, at + 1, saved + cost_now - cost);
  }
  choose(decision, now);
}

}  // namespace tramline
