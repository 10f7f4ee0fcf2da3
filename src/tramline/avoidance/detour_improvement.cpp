// What each choice is worth while the others stay, and better choices.

#include <algorithm>
#include <utility>

#include "tramline/avoidance/decision_rounds.h"
#include "tramline/avoidance/detour_decisions.h"

namespace tramline {
namespace {

bool share_a_hazard(const BlockedTrack& a, const BlockedTrack& b) {
  for (const TrackOption& mine : a.options)
    for (const TrackOption& theirs : b.options)
      for (const std::size_t hazard : mine.way.hazards)
        if (std::find(theirs.way.hazards.begin(), theirs.way.hazards.end(), hazard) !=
            theirs.way.hazards.end())
          return true;
  return false;
}

}  // namespace

void DetourDecisions::value(Decision& decision) {
  const StripWork& own = ground_.at(decision.track.subfield, strip_of(decision).index);
  decision.track.only_one_driven = driven_ == (is_driven(own) ? 1 : 0);
  value_options(decision.track, strips_of(decision), body_[decision.track.subfield], ground_, least_m_);
}

/// What the track's best choice saves against what it does now.
double DetourDecisions::saving_of(Decision& decision, std::vector<StripDetour>* best_detours) {
  value(decision);
  const Strip& strip = strip_of(decision);
  const auto best = cheapest_choice(decision.track, strip, width_m_, task_.objective, least_m_);
  if (!best || same_detours(best->detours, decision.chosen)) return 0;
  if (best_detours != nullptr) *best_detours = best->detours;
  return track_cost(decision.track, strip, width_m_, decision.chosen, task_.objective, least_m_) - best->cost;
}

bool DetourDecisions::improve() {
  const auto saving = [this](Decision& decision, std::vector<StripDetour>* best) {
    return saving_of(decision, best);
  };
  const auto chosen = [this](Decision& decision, std::vector<StripDetour> detours) {
    choose(decision, std::move(detours));
  };
  const std::vector<Decision*> order = by_saving(tracks_, saving);
  const bool singly = improve_one_by_one(order, saving, chosen);
  if (!improve_pairs()) return singly;
  improve_one_by_one(order, saving, chosen);
  return true;
}

/// A pole on the line between two tracks: what suits either while the other stays need not be what suits
/// both.
bool DetourDecisions::improve_pairs() {
  const auto one_pole = [this](std::size_t i, std::size_t j) {
    if (j >= tracks_.size()) return false;
    const BlockedTrack &a = tracks_[i].track, &b = tracks_[j].track;
    return a.subfield == b.subfield && b.strip == a.strip + 1 && a.gaps.size() == 1 && b.gaps.size() == 1 &&
           share_a_hazard(a, b);
  };
  bool any = false;
  for (std::size_t i = 0; i + 1 < tracks_.size(); ++i) {
    if (!one_pole(i, i + 1) || one_pole(i + 1, i + 2) || (i > 0 && one_pole(i - 1, i))) continue;
    any = improve_pair(tracks_[i], tracks_[i + 1]) || any;
  }
  return any;
}

/// Every choice for the first with the best one for the second.
bool DetourDecisions::improve_pair(Decision& first, Decision& second) {
  const std::vector<StripDetour> first_now = first.chosen, second_now = second.chosen;
  std::vector<std::vector<StripDetour>> choices{{}};
  for (const TrackOption& option : first.track.options) choices.push_back({option.way.detour});
  const auto cost_of = [this](Decision& decision, const std::vector<StripDetour>& detours) {
    value(decision);
    return track_cost(decision.track, strip_of(decision), width_m_, detours, task_.objective, least_m_);
  };
  double most_saved = kWorthIt;
  std::vector<StripDetour> best_first, best_second;
  for (const std::vector<StripDetour>& choice : choices) {
    if (same_detours(choice, first_now)) continue;
    double saved = cost_of(first, first_now) - cost_of(first, choice);
    choose(first, choice);
    saved += cost_of(second, second_now);
    const auto answer = cheapest_choice(second.track, strip_of(second), width_m_, task_.objective, least_m_);
    if (answer && saved - answer->cost > most_saved) {
      most_saved = saved - answer->cost;
      best_first = choice;
      best_second = answer->detours;
    }
    choose(first, first_now);
  }
  if (most_saved <= kWorthIt) return false;
  choose(first, std::move(best_first));
  choose(second, std::move(best_second));
  return true;
}

}  // namespace tramline
