#pragma once
// Keys and values as a table of a file.

#include "tramline/io/geopackage/metadata.h"
#include "tramline/io/geopackage/rows.h"
#include "tramline/io/geopackage/table.h"

namespace tramline::io {

/// Failures of GDAL are left to the GdalErrors of the caller.
void write_metadata_table(const Target& target, const Metadata& metadata);
Metadata read_metadata_table(Rows& file);

}  // namespace tramline::io
