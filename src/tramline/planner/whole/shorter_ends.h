#pragma once
// Ends of tracks that are left a little early, or begun a little late, so that the machine turns at once.

#include <cstddef>
#include <vector>

#include "tramline/planner/headland_choice/headland_trial.h"

namespace tramline {

/// In one plan ends are shortened so often at the most.
inline constexpr int kTimesShortened = 3;

/// A piece that ends early and the next one on the route, which begins late.
struct ShorterEnds {
  std::size_t before = 0;  ///< index into Plan::pieces; the other is the next one
  double end_m = 0;        ///< by so much the piece ends early
  double start_m = 0;      ///< by so much the next one begins late
  double saved = 0;        ///< EUR, about, beyond what their land is worth
};

/// The most that shorter ends are expected to save on the route, EUR: the ways between pieces, but for
/// shortest ones forward from where both pieces end side by side. Precondition: the plan has its route. O(n).
double most_saved_by_shorter_ends(const HeadlandTrial& trial);

/// Ends by which two pieces are shorter so that a turn before them has room where the way between them is
/// longer. What is saved is at least a tenth of a euro beyond the worth of the land that is left, and at
/// least as much again: where a headland is just as deep as a turn, an end that lies a hand's breadth behind
/// its neighbour's asks for a full circle or a stop otherwise. Ends beside passable obstacles and on detours
/// stay, and so do all of tracks as in Zhou.
/// Precondition: the plan has its route. O(n) searches for turns, some dozens for each such way.
std::vector<ShorterEnds> ends_worth_shortening(const HeadlandTrial& trial);

/// The same plan with these ends; its draft is still the one without them. Precondition: they are of this
/// plan, each piece ended early once at the most, and begun late once.
HeadlandTrial shortened(const std::vector<ShorterEnds>& ends, HeadlandTrial trial);

/// The trial with all ends that are worth shortening, and its route planned anew, again and again while that
/// costs less, a few times: other ends follow one another on the new route. Precondition: the plan has its
/// route.
HeadlandTrial with_shorter_ends(HeadlandTrial trial);

}  // namespace tramline
