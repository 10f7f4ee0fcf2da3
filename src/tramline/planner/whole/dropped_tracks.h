#pragma once
// Tracks that are left out of a plan because the ways to them cost more than their land is worth.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/planner/headland_choice/headland_trial.h"

namespace tramline {

/// Less is not worth leaving land unworked, EUR.
inline constexpr double kLeastSavedByDropping = 0.5;

/// Pieces that follow one another on a route.
struct PieceRun {
  std::size_t first = 0, count = 0;  ///< indices into Plan::pieces
  double saved = 0;                  ///< EUR, about: less than nothing where they are worth their ways
};

/// Runs of up to eight pieces without which the plan may cost less, the most first; between any two of them
/// lies a piece that stays, so that no way counts for both. What is saved are the ways to, between and from
/// them, but for a shortest one past them, the work on them, and their stops and legs without room; what is
/// lost, the land in their swaths. Pieces that a passable obstacle joins are none, nor all pieces of a plan.
/// Precondition: the plan has its route. O(n).
std::vector<PieceRun> not_worth_their_ways(const HeadlandTrial& trial);

/// The same plan without these pieces, which are listed as dropped; its draft is still the one with them.
/// Precondition: some piece is left.
HeadlandTrial without(const std::vector<PieceRun>& runs, HeadlandTrial trial);

}  // namespace tramline
