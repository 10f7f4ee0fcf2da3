#pragma once
// The formats a plan can be exported to, and the requirements of each.

#include <filesystem>
#include <string>

namespace tramline::io {

enum class ExportFormat { kGeoJson, kFlatGeobuf, kKml, kShapefiles };

/// .geojson, .fgb, .kml or .zip, in any case. Throws Error(kBadInput) that lists them for any other name.
ExportFormat export_format_of(const std::filesystem::path& path);

/// The name for people: "GeoJSON", "FlatGeobuf", "KML", "Shapefiles".
const char* name(ExportFormat format);
/// The name of GDAL's driver.
const char* driver_of(ExportFormat format);
/// Whether the format is always in WGS 84: RFC 7946 and OGC KML allow no other CRS.
bool always_wgs84(ExportFormat format);
/// Whether a file holds one layer only.
bool single_layer(ExportFormat format);

}  // namespace tramline::io
