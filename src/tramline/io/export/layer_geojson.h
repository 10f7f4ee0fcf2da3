#pragma once
// One layer of a tramline file as GeoJSON, for a map on a screen.

#include <filesystem>
#include <string>

#include "tramline/model/local_frame.h"

namespace tramline::io {

/// The layer as GeoJSON (RFC 7946), with longitude and latitude on WGS 84; features, columns and lines as in
/// export_plan(). `frame` is that of the file; a plain one is shown as if its local metres were those of the
/// transverse Mercator centred on (0°, 0°). Throws Error(kBadInput) where there is no such file or layer, or
/// the layer has no shapes; Error(kFailure) where GDAL reports a failure. Shapes may deviate by `tolerance_m`
/// from those of the file to need fewer vertices. O(n log n).
std::string layer_geojson(const std::filesystem::path& file, const LocalFrame& frame,
                          const std::string& layer, double tolerance_m = 0);

/// The geodetic frame in which a map shows local metres of `frame`: the frame itself, or that centred on
/// (0°, 0°).
LocalFrame shown_frame(const LocalFrame& frame);

}  // namespace tramline::io
