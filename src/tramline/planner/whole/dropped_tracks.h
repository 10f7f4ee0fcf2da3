#pragma once
// Tracks that are left out of a plan because the ways to them cost more than their land is worth.

#include <cstddef>
#include <vector>

#include "tramline/planner/headland_choice/headland_trial.h"

namespace tramline {

/// Pieces that follow one another on a route.
struct PieceRun {
  std::size_t first = 0, count = 0;  ///< indices into Plan::pieces
  double saved = 0;                  ///< EUR, about, beyond what their land is worth
};

/// Runs of up to eight pieces that are not worth their ways, those without which most is saved first; between
/// any two of them lies a piece that stays, so that no way counts for both. What is saved are the ways to,
/// between and from them, but for a shortest one past them, the work on them, and their stops and legs
/// without room, less the worth of the land in their swaths: half a euro at least, and as much again as that
/// land is worth. Growers would rather work land than leave it, and what a bare corner costs next year is in
/// no price. Pieces that a passable obstacle joins are none, nor all pieces of a plan. Precondition: the plan
/// has its route. O(n).
std::vector<PieceRun> not_worth_their_ways(const HeadlandTrial& trial);

/// Whether a plan without some tracks saves as much. Both have their routes.
bool is_worth_dropping(const Plan& with, const Plan& without);

/// The same plan without these pieces, which are listed as dropped; its draft is still the one with them.
/// Precondition: some piece is left.
HeadlandTrial without(const std::vector<PieceRun>& runs, HeadlandTrial trial);

}  // namespace tramline
