#pragma once
// A single geometry in memory, as other programs hand it over.

#include <string>

#include "tramline/model/raw_feature.h"

namespace tramline::io {

enum class GeometryForm {
  kWkb,      ///< well-known binary (ISO 19125-1), EWKB too
  kWkt,      ///< well-known text (ISO 19125-1)
  kGeoJson,  ///< the geometry of a feature (RFC 7946, section 3.1)
};

/// The geometry as a feature without number and id; coordinates in the order written. Throws Error(kBadInput)
/// where the bytes are no geometry of that form. O(n).
RawFeature read_geometry(const std::string& bytes, GeometryForm form);

}  // namespace tramline::io
