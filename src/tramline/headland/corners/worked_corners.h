#pragma once
// Headland passes that are driven straight on into corners that they would otherwise round, and backed out
// of.

#include <vector>

#include "tramline/headland/headland.h"

namespace tramline {

/// What it costs to work a corner out, in any unit.
struct CornerPrices {
  double missed_per_m2 = 0;   ///< of land left
  double doubled_per_m2 = 0;  ///< of land worked again
  double in_and_out_per_m = 0;
  double per_stop = 0;
};

/// A closed pass as it is driven: from where it begins, either way round. It is cut at its corners, and where
/// it begins if that is where a route enters it.
struct Round {
  Path path;  ///< empty: as in the headland
  bool entered = false;
};

/// A headland with corners worked out, and what that saves by the prices.
struct WorkedCorners {
  Headland headland;  ///< without `unworked`
  double saved = 0;
};

/// Where a pass turns from its boundary round a corner as tightly as the machine can, land is left outside
/// the arc: R²·(tan ½τ − ½τ) for a turn by τ at the outer radius R. There the pass is cut and driven straight
/// on from the beginning of the arc, or from up to a width before it where that leads farther past an uneven
/// edge, as far as its swath works land for the first time and reaches neither over a boundary nor into the
/// land of passes farther out, if that saves more than it costs. The machine backs out along it, and the next
/// part of the pass begins behind the arc, or with it where the land that the arc still works is worth it. No
/// part is shorter than a width: of corners closer to one another those are worked out that save more. Short
/// open passes in tips are left out where nothing is left for them that is worth a stop. All other passes
/// stay as they are; new ones keep the number and the boundaries of the one they are parts of. O(c·n) for c
/// corners and n segments of passes and corners of the ground.
/// `rounds`: by pass, how a closed one is driven; where the list ends early as in the headland.
/// Preconditions: `headland` is that of the field behind these terms (headland_of()), which are drivable.
WorkedCorners with_worked_corners(const Field& field, const HeadlandTerms& terms, const Headland& headland,
                                  const CornerPrices& prices, const std::vector<Round>& rounds = {});

}  // namespace tramline
