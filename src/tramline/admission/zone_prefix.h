#pragma once
// Eastings prefixed with the number of their zone (32 500 000 for 500 000 in zone 32).

#include <optional>

#include "tramline/geodesy/crs.h"
#include "tramline/model/raw_feature.h"

namespace tramline {

/// The prefix to subtract from the eastings, m (32 000 000), when the CRS is a transverse Mercator grid with
/// false easting 500 000 and all of the feature's eastings have the number of its zone; nullopt when they
/// have none. A CRS whose own false easting holds the zone (EPSG:4647) needs nothing. Throws bad_input,
/// starting with `subject`, when the prefix names another zone than the CRS. O(vertices).
std::optional<double> zone_prefix_m(const RawFeature& feature, const Crs& crs, const std::string& subject);

/// The feature with `prefix_m` subtracted from every easting.
RawFeature without_prefix(RawFeature feature, double prefix_m);

}  // namespace tramline
