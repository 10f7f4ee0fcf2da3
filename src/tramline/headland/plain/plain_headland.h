#pragma once
// Headlands as Zhou et al. 2020 draw them: plain rings with corners, which no machine drives (Zhou §2.3.3).

#include "tramline/headland/headland.h"

namespace tramline {

/// The first pass is the boundary offset by w/2, each further one the offset of the one before by w, and the
/// border of the body b the offset of the last by w/2 (mitred_inset(), mitred_outset()). F_b is the land
/// within b_f that is in none of the obstacles' b_i.
///
/// The paper leaves open what happens where headlands overlap. Here passes with the same number are one ring
/// there, round the land that lies behind all of them: so no swath leaves the field or enters an obstacle,
/// and land where no ring fits, between boundaries less than a width apart, stays unworked. A boundary with
/// fewer passes keeps the others half a width off the border of its headland. A ring that follows only such
/// boundaries is left out. Kinked paths begin in the middle of their longest edge; where they work land
/// twice, that counts as overlap (kinked_cells()).
///
/// O(n²) for n corners.
HeadlandAndBody plain_headland_of(const Field& field, const HeadlandTerms& terms);

}  // namespace tramline
