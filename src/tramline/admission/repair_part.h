#pragma once
// Leads one polygon of a feature through all steps of repair.

#include <vector>

#include "tramline/admission/repair_log.h"
#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// One simple outer ring with its obstacles; a ring that crosses itself gives several.
struct Lobe {
  Ring outer;  ///< simple, counter-clockwise, local metres
  std::vector<Obstacle> obstacles;
};

/// Repairs a part: projects, closes, removes duplicate points and spikes, orients, resolves crossings, sorts
/// the holes. Lobes come largest first; empty when the part has no area (fewer than three points, on one
/// line, or covered by its holes), with the reason in `why_empty`. Throws refusals (see repair_crossings). Σ
/// over the lobes (outer − obstacles) = shoelace area drawn (|outer| − Σ|holes|) + Σ area changes noted.
std::vector<Lobe> repair_part(const RawPolygon& part, RingWinding winding, RepairLog& repair_log,
                              std::string& why_empty);

}  // namespace tramline
