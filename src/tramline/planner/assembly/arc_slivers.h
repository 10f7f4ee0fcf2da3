#pragma once
// Land that only the chords of arcs leave open.

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline {

/// Leaves out slivers (is_sliver()) that are thinner than an overlap that counts, or lie along an edge of the
/// swaths of arcs with all their edges: chords of two swaths along one arc leave them open, where the
/// swaths themselves touch. Others are land, however thin. Nothing where no work follows arcs.
/// O((arcs + slivers) log arcs), more where swaths of arcs lie over one another.
void drop_slivers_along_arcs(const Plan& plan, Region& land);

}  // namespace tramline
