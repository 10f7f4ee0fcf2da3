#pragma once
// Step 6: clips holes to the field.

#include <vector>

#include "tramline/admission/repair_log.h"
#include "tramline/model/field.h"

namespace tramline {

/// The obstacles of each lobe: `holes` cut to the lobes' outer rings. `outers` are simple rings, largest
/// first, that do not cross; one may lie within another (land within an enclosed hole), and then the hole
/// belongs to the inner one. The result has one list per outer ring. Holes outside all of them are dropped,
/// holes that reach outside are clipped, holes that share edges with an outer ring are kept; each is noted,
/// the area outside counting as gained. A hole that touches the outer ring in single points is valid and only
/// gives a warning.
std::vector<std::vector<Obstacle>> clip_holes(const std::vector<Ring>& outers,
                                              const std::vector<Obstacle>& holes, RepairLog& repair_log);

}  // namespace tramline
