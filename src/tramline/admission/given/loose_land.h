#pragma once
// The land of features from other files than the field's.

#include <cstddef>
#include <vector>

#include "tramline/admission/read_obstacles.h"
#include "tramline/admission/repair_log.h"

namespace tramline {

/// The land of a feature in local metres, its faults repaired and noted: lines widened to `size_m` with flat
/// ends, points as axis-parallel squares of `size_m`. Not cut to any field. O(n log n).
Region land_of(const LooseObstacle& feature, double size_m, RepairLog& repair_log);

/// Indices of the features whose boxes meet the field's, grown by `margin_m`. O(features).
std::vector<std::size_t> features_near(const Field& field, double margin_m,
                                       const std::vector<LooseObstacle>& features);

}  // namespace tramline
