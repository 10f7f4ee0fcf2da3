#pragma once

#include <ogrsf_frmts.h>

#include <filesystem>
#include <functional>
#include <string>

#include "tramline/io/geopackage/file_kind.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// Creates a GeoPackage with the contents added by `fill`, in one transaction, and writes it whole or not at
/// all. Its coordinates are those of `frame`: local metres of a geodetic one, the input plane of a plain one.
/// Equal calls of `fill` make equal bytes: time stamps are SOURCE_DATE_EPOCH where that is set, else
/// 1970-01-01.
///
/// Throws Error(kBadInput) for a name that does not end in .gpkg (in any case), Error(kFailure) where GDAL
/// reports a failure or the file cannot be written.
void write_geopackage(const std::filesystem::path& path, const FileKind& kind, const LocalFrame& frame,
                      const std::function<void(const Target&)>& fill);

/// The same into a file of any name that GDAL accepts, which is incomplete until this returns. Failures are
/// left to the GdalErrors of the caller.
void fill_geopackage(const std::string& name, const LocalFrame& frame,
                     const std::function<void(const Target&)>& fill);

}  // namespace tramline::io
