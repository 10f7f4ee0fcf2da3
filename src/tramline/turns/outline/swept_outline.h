#pragma once
// The land that an outline sweeps, as polygons.

#include "tramline/turns/outline/outline.h"

namespace tramline {

/// The land that the outline sweeps on the path, for pictures and tests: polygons from corners that move in
/// chords, no point of which is farther than `sagitta_m` (and the precision grid) from the land swept, nor
/// the other way round. Neither sweeps nor chords have to be convex. Preconditions: sagitta_m > 0; no reverse
/// where the outline tows. O(m log m) for m chords.
Region swept_outline(const SteeredPath& path, const Outline& outline, double sagitta_m);

}  // namespace tramline
