#include "tramline/io/log/log_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "tramline/geometry/error.h"
#include "tramline/io/agopengps/field_folder.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/isoxml/task_files.h"
#include "tramline/io/log/line_log.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::io {
namespace {

bool is_vector_name(const std::string& name) {
  constexpr std::array kEndings = {".geojson",     ".json",   ".geojsonl", ".gpkg",       ".shp",
                                   ".fgb",         ".kml",    ".kmz",      ".gml",        ".sqlite",
                                   ".tab",         ".mif",    ".gdb",      ".geojson.gz", ".json.gz",
                                   ".geojsonl.gz", ".kml.gz", ".gml.gz"};
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

bool is_text_name(const std::string& name) {
  constexpr std::array kEndings = {".csv",    ".txt",    ".log",    ".nmea",   ".tsv",
                                   ".csv.gz", ".txt.gz", ".log.gz", ".nmea.gz"};
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

LogFormat log_format(const std::string& path) {
  if (is_database_string(path)) return LogFormat::kVector;
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw bad_input(fmt::format("there is no file '{}'; check the path", path));
  const std::string name = lower_case(path);
  if (FieldFolder::open(path)) return LogFormat::kAgOpenGps;
  if (std::filesystem::is_directory(path, error) || name.ends_with(".zip"))
    return TaskFiles::looks_like_one(path) ? LogFormat::kIsoxml : LogFormat::kVector;
  if (is_vector_name(name)) return LogFormat::kVector;
  const std::string start = first_bytes(path, kFirstBytes);
  if (start.empty()) throw bad_input(fmt::format("'{}' is empty; give a log with records", path));
  const std::string head = lower_case(start);
  if (head.find("<iso11783_taskdata") != std::string::npos) return LogFormat::kIsoxml;
  if (head.find("<gpx") != std::string::npos) return LogFormat::kGpx;
  if (name.ends_with(".bin") || (name.ends_with(".xml") && head.find("<tim") != std::string::npos))
    return LogFormat::kIsoxml;
  if (has_sentence(start)) return LogFormat::kNmea;
  const bool is_binary = start.find('\0') != std::string::npos;
  const std::string_view text = trimmed(start);
  if (!is_binary && !text.starts_with('<') && !text.starts_with('{')) return LogFormat::kCsv;
  if (text.starts_with('{')) return LogFormat::kVector;
  // Text with wide characters: its reader says what to do.
  if (is_text_name(name) && (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")))
    return LogFormat::kCsv;
  throw bad_input(fmt::format(
      "'{}' is not a known kind of log; give CSV, NMEA 0183, GPX, ISOXML, an AgOpenGPS field folder, or "
      "points in a GeoJSON, GeoPackage or Shapefile",
      path));
}

}  // namespace tramline::io
