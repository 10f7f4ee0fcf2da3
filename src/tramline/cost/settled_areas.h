#pragma once

#include <algorithm>

#include "tramline/model/tally.h"

namespace tramline {

/// Sets the overlap and the uncovered area of a tally whose worked area is known. `useful_m2` is the part of
/// the body that is worked at all. On the precision grid of booleans it may exceed the worked area or the
/// body by some 1e-5 m²: it is limited to both, so that neither area is negative and the identity of Tally
/// holds.
inline void settle_areas(Tally& tally, double useful_m2, double body_m2) {
  const double useful = std::min({useful_m2, tally.worked_m2, body_m2});
  tally.overlap_m2 = tally.worked_m2 - useful;
  tally.uncovered_m2 = body_m2 - useful;
}

}  // namespace tramline
