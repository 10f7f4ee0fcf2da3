#pragma once
// The exact areas that passes work.

#include "tramline/headland/headland.h"

namespace tramline {

/// Fills in worked_m2, overlap_m2 and uncovered_m2 from passes, ground and `passable`, land where the work is
/// interrupted. O(n log n + n·a) for n segments of passes and ground, a of them at one height.
void tally_passes(const Region& passable, double width_m, Headland& headland);

}  // namespace tramline
