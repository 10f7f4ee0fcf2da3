#pragma once

#include <algorithm>

#include "tramline/model/tally.h"

namespace tramline {

/// Sets overlap and uncovered land of a tally whose worked area is known, from `useful_m2`, what of the body
/// is worked at all. On the grid of booleans that may come out some 1e-5 m² more than was worked or than
/// there is: it is no more than either, so neither area is less than nothing, and the identity of Tally holds
/// all the same.
inline void settle_areas(Tally& tally, double useful_m2, double body_m2) {
  const double useful = std::min({useful_m2, tally.worked_m2, body_m2});
  tally.overlap_m2 = tally.worked_m2 - useful;
  tally.uncovered_m2 = body_m2 - useful;
}

}  // namespace tramline
