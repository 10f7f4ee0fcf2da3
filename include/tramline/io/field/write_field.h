#pragma once

#include <filesystem>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/model/field.h"

namespace tramline::io {

/// Writes an admitted field as a GeoPackage with the layers field and obstacles and the tables metadata and
/// layer_styles. `remarks` go into metadata (remarks.h). Coordinates, bytes and
/// errors as those of write_plan(). O(n).
void write_field(const Field& field, const std::filesystem::path& path, const Metadata& remarks = {});

}  // namespace tramline::io
