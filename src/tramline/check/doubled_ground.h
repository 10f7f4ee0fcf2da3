#pragma once
// Where more than one swath works.

#include <vector>

#include "tramline/geometry/path.h"
#include "tramline/geometry/region.h"

namespace tramline::check {

/// Land thinner than this is rounding: maps do not show it, and nobody asks for it. m
inline constexpr double kThinnestShown_m = 1e-5;

/// What any two of the polygons have in common, pair by pair, but for what is thinner than kThinnestShown_m:
/// where three lie over one another these parts do, too. Every polygon has to be valid.
/// O(n·log n + k) for k pairs whose boxes meet.
Region doubled_ground(const Region& swaths);

/// The same of swaths of one width with the middle of each: where these are as far apart as the swaths are
/// wide nothing else has to be looked at. Arcs side by side are, and overlays of their chords take long.
/// Precondition: as many lines as swaths.
Region doubled_ground(const Region& swaths, const std::vector<Path>& lines, double width_m);

}  // namespace tramline::check
