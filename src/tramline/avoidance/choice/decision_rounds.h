#pragma once
// Tracks are decided by turns, each the best while the others stay.

#include <functional>
#include <vector>

#include "tramline/avoidance/choice/decision.h"

namespace tramline {

/// What the best choice for a track saves against what it does now, and, where asked for, that choice.
using SavingOf = std::function<double(Decision&, std::vector<TrackDetour>* best)>;
using Choose = std::function<void(Decision&, std::vector<TrackDetour> detours)>;

/// Those that save most come first: an order that does not depend on how the field lies in its frame.
std::vector<Decision*> by_saving(std::vector<Decision>& decisions, const SavingOf& saving_of);

/// Gives every track in this order what saves, again and again those that are stale, until none changes.
/// Every change saves, so the rounds come to an end. False where nothing changed.
bool improve_one_by_one(const std::vector<Decision*>& order, const SavingOf& saving_of, const Choose& choose);

}  // namespace tramline
