#pragma once
// Land that only the chords of arcs leave open.

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline {

/// Leaves out slivers (is_sliver()) that chords of arcs leave open where two swaths touch: those of which all
/// edges lie along edges of swaths of arcs. Those thinner than an overlap that counts are rounding and are
/// left out as well; others are land, however thin. Leaves everything where no work follows arcs.
/// O((arcs + slivers) log arcs), more where swaths of arcs lie over one another.
void drop_slivers_along_arcs(const Plan& plan, Region& land);

}  // namespace tramline
