#pragma once
// The colours of application rates.

#include "tramline/model/palette.h"

namespace tramline::render {

/// The colour of a rate given as a multiple of the reference: blue below it, pale green at it, orange and
/// then brown above it, distinguishable with any of the common colour deficiencies; constant beyond
/// kMostShown.
Colour dose_colour(double multiple);

inline constexpr double kMostShown = 2.5;

/// Opacity outside the ground, 0 to 1: a low rate there should fade out and not look like too little.
double opacity_off_ground(double multiple);

}  // namespace tramline::render
