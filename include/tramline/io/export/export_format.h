#pragma once
// The formats a plan is exported to, and what each of them asks for.

#include <filesystem>
#include <string>

namespace tramline::io {

enum class ExportFormat { kGeoJson, kFlatGeobuf, kKml, kShapefiles };

/// .geojson, .fgb, .kml or .zip, in any case. Throws Error(kBadInput) that lists them for any other name.
ExportFormat export_format_of(const std::filesystem::path& path);

/// For people: "GeoJSON", "FlatGeobuf", "KML", "Shapefiles".
const char* name(ExportFormat format);
/// GDAL's driver.
const char* driver_of(ExportFormat format);
/// RFC 7946 and OGC KML know no other CRS.
bool always_wgs84(ExportFormat format);
/// Files that hold one layer only.
bool single_layer(ExportFormat format);

}  // namespace tramline::io
