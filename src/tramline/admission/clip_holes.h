#pragma once
// Step 6: holes lie in the field.

#include <vector>

#include "tramline/admission/repair_log.h"
#include "tramline/model/field.h"

namespace tramline {

/// The obstacles of each lobe: `holes` cut to the lobes' outer rings. `outers` are simple rings, largest
/// first, that do not cross; one may lie within another (land within an enclosed hole), and then the inner
/// one takes the hole. The result has one list per outer ring. Holes outside all of them are dropped, holes
/// that reach outside are clipped, holes that share edges with an outer ring are kept; each is noted, the
/// area outside counting as gained. A hole that touches the outer ring in single points is lawful: a warning.
std::vector<std::vector<Obstacle>> clip_holes(const std::vector<Ring>& outers,
                                              const std::vector<Obstacle>& holes, RepairLog& repair_log);

}  // namespace tramline
