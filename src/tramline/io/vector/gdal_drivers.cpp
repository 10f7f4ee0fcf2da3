#include "tramline/io/vector/gdal_drivers.h"

#include <gdal.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "tramline/io/gdal/start_gdal.h"

namespace tramline::io {
namespace {

/// What fields and logs come in, and what the project's own files are.
constexpr std::array kPlainFiles = {"GPKG",        "GeoJSON",
                                    "GeoJSONSeq",  "TopoJSON",
                                    "ESRIJSON",    "ESRI Shapefile",
                                    "FlatGeobuf",  "KML",
                                    "LIBKML",      "GML",
                                    "GPX",         "DXF",
                                    "DGN",         "CSV",
                                    "JML",         "SQLite",
                                    "S57",         "MapInfo File",
                                    "OpenFileGDB", "MEM",
                                    "Memory",      static_cast<const char*>(nullptr)};

}  // namespace

void register_gdal_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    start_gdal();
    GDALAllRegister();
  });
}

bool reads_plain_files(const std::string& driver) {
  return std::any_of(kPlainFiles.begin(), kPlainFiles.end() - 1,
                     [&](const char* name) { return driver == name; });
}

const char* const* plain_file_drivers() { return kPlainFiles.data(); }

}  // namespace tramline::io
