#pragma once
// How much was applied, as a colour.

#include "tramline/model/palette.h"

namespace tramline::render {

/// Of the rate as a multiple of the reference: blue below it, pale green at it, orange and then brown
/// above it, told apart by people with any of the common colour deficiencies; the same beyond kMostShown.
Colour dose_colour(double multiple);

inline constexpr double kMostShown = 2.5;

/// Beyond the ground little is to look like little, not like too little: opacity there, 0 to 1.
double opacity_off_ground(double multiple);

}  // namespace tramline::render
