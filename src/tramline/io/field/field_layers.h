#pragma once
// The layers field and obstacles, which files of fields and of plans have in common.

#include <filesystem>
#include <functional>

#include "tramline/io/field/field_file.h"
#include "tramline/io/geopackage/rows.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/model/field.h"

namespace tramline::io {

/// Both layers, obstacles in their order. Failures of GDAL are left to the GdalErrors of the caller.
void write_field_layers(const Target& target, const Field& field);

/// The inverse: fills the outer ring and the obstacles. `seen` is called for every row with its polygon.
/// Throws Error(kBadInput) naming file, layer and feature where there is not exactly one field, or a value is
/// missing or of the wrong type.
void read_field_layers(Rows& file, const std::filesystem::path& path, const FileKind& kind, Field& field,
                       const std::function<void(const Row&, const Polygon&)>& seen = {});

}  // namespace tramline::io
