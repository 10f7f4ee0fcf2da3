#pragma once
// Zips a folder in memory.

#include <cstddef>
#include <ctime>
#include <span>
#include <string>
#include <vector>

#include "tramline/io/geopackage/memory_folder.h"

namespace tramline::io {

/// Packs the named files of the folder into a new file `zip` of it, in this order, deflated, each with
/// `time` (in UTC, and at least 1980, where the format begins). Failures are left to the GdalErrors of the
/// caller.
void zip_files(const MemoryFolder& folder, const std::vector<std::string>& names, const std::string& zip,
               std::time_t time);

/// Sets the time of every entry of a zip file: GDAL leaves them at zero, which is no date. Throws
/// Error(kFailure) where the bytes are no zip file.
void stamp_zip(std::span<std::byte> zip, std::time_t time);

}  // namespace tramline::io
