#pragma once
// Admission of a feature as a field: finds faults, makes unambiguous repairs, reports them, and refuses the
// rest.

#include <string>
#include <vector>

#include "tramline/geodesy/crs.h"
#include "tramline/model/field.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// The origin of features and the meaning of their coordinates.
struct AdmissionContext {
  std::string file;
  std::string layer;
  const Crs* crs = nullptr;  ///< never null; plain for metres
  RingWinding winding = RingWinding::kFree;
};

/// The result of admitting a feature.
struct Admission {
  std::vector<Field> fields;     ///< at least one
  std::vector<Skipped> skipped;  ///< lines and points that the feature has besides polygons
};

/// The feature's id, or "layer:fid" when it has none.
std::string field_id(const RawFeature& feature, const std::string& layer);

/// Each polygon of the feature becomes a field, and each lobe of a ring that crosses itself; the second gets
/// the id "…#2". Field coordinates are local metres. In every field the outer ring is simple and
/// counter-clockwise, the obstacles are valid, lie within it and share no land.
/// Throws bad_input, one sentence that names file and feature, for: no polygon, coordinates that are not
/// finite or not on the globe, a CRS that cannot be right, no area, rings that are tangled or do not
/// determine what they enclose, and boundaries with more corners than kMostCorners once thinned
/// (thin_rings.h). O(n log n) per ring, and O(holes²) box tests.
Admission admit(const RawFeature& feature, const AdmissionContext& context);

}  // namespace tramline
