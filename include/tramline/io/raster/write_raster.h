#pragma once

#include <filesystem>

#include "tramline/model/dose_map.h"

namespace tramline::io {

/// The value of cells that got nothing and lie outside the evaluated land.
inline constexpr float kNoDose = -9999;

/// Writes the map as a GeoTIFF of one band, float32, deflated: the applied amount per hectare in every cell,
/// so that the sum over cells times their area is the applied amount. Its plane is that of a coverage file: a
/// transverse Mercator on WGS 84 centred on the field, or the input's own plane where that was plain metres.
/// Equal maps make equal files. The file is written whole or not at all. Throws Error(kBadInput) for a name
/// that does not end in .tif or .tiff (in any case), Error(kFailure) where GDAL reports a failure or the file
/// cannot be written. O(cells).
void write_raster(const DoseMap& map, const std::filesystem::path& path);

}  // namespace tramline::io
