#include "tramline/io/log/gpx_log.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/civil_time.h"
#include "tramline/io/fixes/course_heading.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/places.h"

namespace tramline::io {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// "gpxtpx:speed" is "speed".
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// The number in the child of this name, or in its like among the extensions, which some nest once more.
double number_below(const pugi::xml_node& node, std::string_view name, int depth = 0) {
  constexpr int kDeepest = 3;
  for (const pugi::xml_node child : node.children()) {
    if (local_name(child) == name) return number_in(child.child_value()).value_or(kNone);
    if (depth == 0 && local_name(child) != "extensions") continue;
    if (depth == kDeepest) continue;
    if (const double inner = number_below(child, name, depth + 1); !std::isnan(inner)) return inner;
  }
  return kNone;
}

pugi::xml_node child_called(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node child : node.children())
    if (local_name(child) == name) return child;
  return {};
}

void add_point(const pugi::xml_node& point, int unit, std::size_t record, WorkLog& log) {
  const auto lon = number_in(point.attribute("lon").value()), lat = number_in(point.attribute("lat").value());
  const Point lonlat = {lon.value_or(kNone), lat.value_or(kNone)};
  if (std::string fault = fault_of_lonlat(lonlat); !fault.empty()) {
    log.skipped.add(record, std::move(fault));
    return;
  }
  Fix fix;
  fix.record = record;
  fix.position = lonlat;
  fix.unit = unit;
  fix.time_s = date_time_s(child_called(point, "time").child_value()).value_or(kNone);
  fix.speed_mps = number_below(point, "speed");
  fix.heading = heading_of_course(number_below(point, "course"), fix.speed_mps);
  if (!std::isnan(fix.time_s)) log.clock = Clock::kUtc;
  log.fixes.push_back(fix);
}

}  // namespace

WorkLog read_gpx_log(std::string_view text, const std::string& place) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  if (!parsed)
    throw bad_input(fmt::format("{} is damaged XML at byte {} ({}); fetch or export it again", place,
                                parsed.offset, parsed.description()));
  WorkLog log;
  int unit = 0;
  std::size_t record = 0;
  const pugi::xml_node root = child_called(document, "gpx");
  for (const pugi::xml_node track : root.children()) {
    if (local_name(track) != "trk") continue;
    for (const pugi::xml_node segment : track.children()) {
      if (local_name(segment) != "trkseg") continue;
      for (const pugi::xml_node point : segment.children())
        if (local_name(point) == "trkpt") add_point(point, unit, ++record, log);
      ++unit;
    }
  }
  if (log.fixes.empty())
    throw bad_input(
        fmt::format("{} has no track point with a possible position ({} were skipped); routes and "
                    "waypoints are no log",
                    place, log.skipped.count));
  if (unit > 1) log.notes.push_back(fmt::format("{} track segments: nothing is worked between them", unit));
  skip_strays(log);
  return log;
}

}  // namespace tramline::io
