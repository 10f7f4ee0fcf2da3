#pragma once
// GDAL's drivers, and which of them read a file that somebody names.

#include <string>

namespace tramline::io {

/// Starts GDAL (start_gdal()) and registers its drivers, once per process.
void register_gdal_drivers();

/// Does the driver of this name read files that hold everything themselves: none that leads to other files,
/// databases or the network (VRT, WFS …)?
bool reads_plain_files(const std::string& driver);

/// The names of all such drivers, ended by nullptr, as GDALDataset::Open takes them.
const char* const* plain_file_drivers();

}  // namespace tramline::io
