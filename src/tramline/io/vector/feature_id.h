#pragma once
// What a feature calls itself.

#include <string>

class OGRFeature;

namespace tramline::io {

/// The property called id (any case), or the GeoJSON member "id"; empty when it has neither.
std::string feature_id(const OGRFeature& feature);

}  // namespace tramline::io
