#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tramline/io/export/export_format.h"
#include "tramline/model/report.h"

namespace tramline::io {

struct ExportRequest {
  std::filesystem::path plan;  ///< a plan file, or a coverage file
  std::filesystem::path file;  ///< its extension chooses the format
  std::string crs;  ///< "source", "wgs84" or a definition for Crs; empty: the format's default, see below
  /// Layers of the plan file, the legs of its route as `route`; empty: tracks and headland passes, in KML the
  /// route too, or all with shapes in Shapefiles. Of a coverage file: its gaps, or all.
  std::vector<std::string> layers;
  double tolerance_m = 0.02;  ///< see below; 0: every vertex is kept
  std::string field{};        ///< key or id of a field in a file of many plans; empty: all of them
};

struct ExportedLayer {
  std::string name;
  int features = 0;
};

struct ExportReport {
  ExportFormat format = ExportFormat::kGeoJson;
  std::string field_id;  ///< that of the first field, where there are several
  std::size_t fields = 1;
  std::string crs;  ///< for people: "WGS 84 (EPSG:4326)"
  std::vector<ExportedLayer> layers;
  std::vector<Skipped> shortened;  ///< texts that were too long for the format
};

/// Writes layers of a plan file to a file that other programs read: GeoJSON (RFC 7946) and KML in WGS 84,
/// FlatGeobuf and zipped Shapefiles in the CRS the field was given in, unless the request names another.
/// Lines and outlines stay within `tolerance_m` of those in the plan file and have no more vertices than that
/// requires; the field and its obstacles keep all of theirs. Features keep their order, and all columns are
/// kept except `path` and `detours`, which only tramline can read: they are replaced by the number of detours
/// and, but in Shapefiles, by `exact_path` (exact_path.h). Where a file holds one layer, headland passes
/// follow the tracks in theirs, with the kind `headland`.
///
/// The same plan file gives the same bytes; times inside follow time_of_files(). The file is written whole
/// or not at all.
///
/// Throws Error(kBadInput) where the tolerance is not from 0 to 10 m, the plan file is missing or not a plan,
/// the extension unknown, a layer unknown or without shapes, the layers too many for the format, all
/// requested layers empty, or the CRS not possible (TargetCrs); Error(kFailure) where the file cannot be
/// written. O(n) in vertices.
ExportReport export_plan(const ExportRequest& request);

/// Plans for terminals that read ISOXML.
struct TaskSetRequest {
  std::vector<std::filesystem::path> plans;  ///< plan files, of one plan or of many, and coverage files
  std::filesystem::path target;              ///< a .zip, or a folder; see below
  TaskDataVersion version = TaskDataVersion::k4;
  LineChoice lines = LineChoice::kSubfields;
  ObstacleStyle obstacles = ObstacleStyle::kHoles;
  double tolerance_m = 0.02;  ///< of curves and of the headland's outline
  std::string field{};        ///< key or id of the only field wanted; empty: all of all files
  std::string customer = "Customer", farm = "Farm";
};

/// A name that a terminal shows otherwise than it was given.
struct ChangedName {
  std::string name;
  std::string shown;
};

struct TaskSetReport {
  std::filesystem::path file;  ///< the zip, or TASKDATA.XML
  std::size_t fields = 0, lines = 0, curves = 0, obstacles = 0,
              headlands = 0;  ///< curves are among the lines
  std::size_t gaps = 0;       ///< of repair plans and coverage files
  std::size_t bytes = 0;      ///< of TASKDATA.XML
  std::vector<ChangedName> changed;
};

/// Writes one ISOXML task set (ISO 11783-10) of all the plans: for each field a partfield with boundary,
/// obstacles, headland and guidance lines, and a planned task; the gaps of repair plans and coverage files
/// are polygons of type 8, other. A zip holds TASKDATA/TASKDATA.XML. A target that is called TASKDATA becomes
/// that folder; any other folder gets a folder TASKDATA, whether it is there already or not. The same plans
/// give the same bytes. Written whole or not at all. Coordinates are WGS 84 with nine decimals.
///
/// Throws Error(kBadInput) where the tolerance is not from 0 to 10 m, a file is missing or not a plan,
/// `field` names none or several, a field is in plain metres, or a folder TASKDATA is there and not empty;
/// Error(kFailure) where nothing can be written. O(n) in vertices.
TaskSetReport export_task_set(const TaskSetRequest& request);

/// Plans for AgOpenGPS.
struct AgOpenGpsRequest {
  std::vector<std::filesystem::path> plans;  ///< plan files, of one plan or of many, and coverage files
  std::filesystem::path target;              ///< a new folder, or a .zip
  LineChoice lines = LineChoice::kSubfields;
  double tolerance_m = 0.02;  ///< of curves and of the headland line
  std::string field{};        ///< key or id of the only field wanted; empty: all of all files
};

struct AgOpenGpsReport {
  std::vector<std::string> folders;  ///< one for each field; of a single one in a folder that of the target
  std::size_t lines = 0, curves = 0, obstacles = 0;  ///< curves are among the lines
  std::vector<ChangedName> changed;
};

/// Writes field folders of AgOpenGPS (Field.txt, Boundary.txt, Headland.txt, TrackLines.txt, Sections.txt):
/// of one plan the target becomes the field's folder, of several it gets one for each; a .zip has a folder
/// for each in any case. The same plans give the same bytes. Written whole or not at all. Coordinates are
/// metres with three decimals in the plane of AgOpenGPS.
///
/// Throws as export_task_set(), and Error(kBadInput) where the target is there and not empty. O(n) in
/// vertices.
AgOpenGpsReport export_agopengps(const AgOpenGpsRequest& request);

/// The route of a plan for autopilots, robots and drones.
struct RouteRequest {
  std::filesystem::path plan;  ///< a plan file; for GPX also a coverage file
  std::filesystem::path file;
  RouteFormat format = RouteFormat::kGpx;
  std::filesystem::path machine{};  ///< a machine file that says how a drone flies; empty: on the ground
  double tolerance_m = 0.02;        ///< between the route and the lines between its points; above 0
  std::string field{};              ///< key or id of a field in a file of many plans
};

struct RouteReport {
  RouteFormat format = RouteFormat::kGpx;
  std::string field_id;
  std::size_t points = 0;
  double length_m = 0;
  std::size_t gaps = 0;            ///< of a coverage file or a repair plan, which have no route
  std::vector<std::string> notes;  ///< what the file does not say, and why
};

/// Writes the route of one plan, or to GPX the gaps of a coverage file or of a repair plan, a place and an
/// outline each, with the passes of the latter. Missions
/// have commands where speed, gear and work change, and those that fly take off and land; a .plan has a fence
/// of field and obstacles where the route respects them. The same plan gives the same bytes. The file is
/// written whole or not at all.
///
/// Throws Error(kBadInput) where the tolerance is not above 0 m and at most 10 m, the plan file is missing or
/// not a plan, has no route, or is in plain metres where the format is not kRobot; where a drone's altitude
/// is missing, and where the route is beyond a limit of the format. Error(kFailure) where the file cannot be
/// written. O(n) in stretches and points, in a .plan times the vertices of the field.
RouteReport export_route(const RouteRequest& request);

}  // namespace tramline::io
