#pragma once
// GDAL's drivers, and the subset that reads plain files.

#include <string>

namespace tramline::io {

/// Starts GDAL (start_gdal()) and registers its drivers, once per process.
void register_gdal_drivers();

/// Whether the driver of this name reads self-contained files only: none that leads to other files, databases
/// or the network (VRT, WFS …).
bool reads_plain_files(const std::string& driver);

/// The names of all such drivers, terminated by nullptr, for GDALDataset::Open.
const char* const* plain_file_drivers();

}  // namespace tramline::io
