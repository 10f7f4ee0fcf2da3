#include "tramline/io/export/export_format.h"

#include <fmt/format.h>

#include <algorithm>

#include "tramline/geometry/error.h"

namespace tramline::io {

ExportFormat export_format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (extension == ".geojson") return ExportFormat::kGeoJson;
  if (extension == ".fgb") return ExportFormat::kFlatGeobuf;
  if (extension == ".kml") return ExportFormat::kKml;
  if (extension == ".zip") return ExportFormat::kShapefiles;
  throw bad_input(
      fmt::format("'{}' does not name a format that plans are exported to; end the name in .geojson, .fgb "
                  "(FlatGeobuf), .kml or .zip (Shapefiles)",
                  path.string()));
}

const char* name(ExportFormat format) {
  switch (format) {
    case ExportFormat::kGeoJson:
      return "GeoJSON";
    case ExportFormat::kFlatGeobuf:
      return "FlatGeobuf";
    case ExportFormat::kKml:
      return "KML";
    case ExportFormat::kShapefiles:
      return "Shapefiles";
  }
  return "";
}

const char* driver_of(ExportFormat format) {
  return format == ExportFormat::kShapefiles ? "ESRI Shapefile" : name(format);
}

bool always_wgs84(ExportFormat format) {
  return format == ExportFormat::kGeoJson || format == ExportFormat::kKml;
}

bool single_layer(ExportFormat format) {
  return format == ExportFormat::kGeoJson || format == ExportFormat::kFlatGeobuf;
}

}  // namespace tramline::io
