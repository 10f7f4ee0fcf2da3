#pragma once
// The formats a plan can be exported to, and the requirements of each.

#include <filesystem>
#include <optional>
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

/// Versions of ISO 11783-10: 3 is that of 2009, 4 that of 2015.
enum class TaskDataVersion { k3 = 3, k4 = 4 };
/// How obstacles are told to a terminal. kHoles: as interior rings of the boundary. kPolygons: as polygons of
/// their own.
enum class ObstacleStyle { kHoles, kPolygons };
/// Which lines a terminal gets. kSubfields: one for each subfield, to which it makes parallels itself. kAll:
/// every track and headland pass of the plan, to be driven as they are.
enum class LineChoice { kSubfields, kAll };

/// The formats of routes: a GPS track, missions of QGroundControl and ArduPilot (.plan, .waypoints) and of
/// DJI drones (.kmz), and for robots a nav_msgs/Path with the typed segments of the way (.yaml, .json).
enum class RouteFormat { kGpx, kQgcPlan, kQgcWaypoints, kDji, kRobot };
/// By the extension, in any case; nullopt for any other.
std::optional<RouteFormat> route_format_of(const std::filesystem::path& file);
const char* name(RouteFormat format);

}  // namespace tramline::io
