#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "tramline/geometry/error.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/export/file_set.h"
#include "tramline/io/export/thinned_line.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/io/machine/read_flight.h"
#include "tramline/io/mission/route_texts.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/vector/lower_case.h"

namespace tramline::io {
namespace {

Plan plan_with_route(const RouteRequest& request) {
  Plan plan = read_plan(request.plan, request.field);
  if (!plan.route.planned())
    throw bad_input(
        fmt::format("{}: the plan of field '{}' has tracks and no route; plan it again with --route",
                    request.plan.string(), plan.field.id));
  if (!plan.field.frame.geodetic && request.format != RouteFormat::kRobot)
    throw bad_input(
        fmt::format("{}: field '{}' is in plain metres, which have no place on the globe; only .yaml and "
                    ".json take it",
                    request.plan.string(), plan.field.id));
  return plan;
}

/// nullopt for a machine on the ground.
std::optional<Flight> flight_of(const RouteRequest& request) {
  std::optional<Flight> out;
  if (!request.machine.empty()) out = read_flight(request.machine);
  if (out || (request.format != RouteFormat::kDji && request.machine.empty())) return out;
  if (request.format == RouteFormat::kDji)
    throw bad_input(
        "a DJI mission needs the altitude of the drone; name a machine file with flight_altitude_m with "
        "--machine");
  throw bad_input(
      fmt::format("{}: there is no flight_altitude_m in it; leave --machine out for a machine on the ground",
                  request.machine.string()));
}

void write_text(const std::string& text, const std::filesystem::path& file) {
  write_whole(file, std::as_bytes(std::span(text.data(), text.size())));
}

RouteReport export_gaps(const RouteRequest& request) {
  const Coverage coverage = read_coverage(request.plan);
  if (!coverage.frame.geodetic)
    throw bad_input(fmt::format("{}: field '{}' is in plain metres, which have no place on the globe",
                                request.plan.string(), coverage.field_id));
  if (coverage.gaps.empty())
    throw bad_input(
        fmt::format("{}: there are no gaps in it, so there is nothing to export", request.plan.string()));
  write_text(gaps_gpx_text(coverage), request.file);
  return {request.format, coverage.field_id, 0, 0, coverage.gaps.size(), {}};
}

}  // namespace

std::optional<RouteFormat> route_format_of(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".gpx") return RouteFormat::kGpx;
  if (extension == ".plan") return RouteFormat::kQgcPlan;
  if (extension == ".waypoints") return RouteFormat::kQgcWaypoints;
  if (extension == ".kmz") return RouteFormat::kDji;
  if (extension == ".yaml" || extension == ".yml" || extension == ".json") return RouteFormat::kRobot;
  return std::nullopt;
}

const char* name(RouteFormat format) {
  switch (format) {
    case RouteFormat::kGpx:
      return "GPX";
    case RouteFormat::kQgcPlan:
      return "QGroundControl plan";
    case RouteFormat::kQgcWaypoints:
      return "QGC WPL 110";
    case RouteFormat::kDji:
      return "DJI WPML";
    case RouteFormat::kRobot:
      return "nav_msgs/Path and segments";
  }
  return "";
}

RouteReport export_route(const RouteRequest& request) {
  require_tolerance(request.tolerance_m);
  if (request.format == RouteFormat::kGpx && is_coverage_file(request.plan)) return export_gaps(request);
  if (request.tolerance_m == 0)
    throw bad_input("--tolerance must be above 0 m for a route: its arcs become lines between points");
  const std::optional<Flight> flight = flight_of(request);
  const Plan plan = plan_with_route(request);
  const std::vector<WayPoint> route = way_points(plan, request.tolerance_m);
  RouteReport report{request.format, plan.field.id, route.size(), length_of(route), 0, {}};
  switch (request.format) {
    case RouteFormat::kGpx:
      write_text(gpx_text(plan, route), request.file);
      break;
    case RouteFormat::kQgcPlan: {
      const Geofence fence = geofence_of(plan, route);
      write_text(qgc_plan_text(plan, mission_of(plan, flight, request.tolerance_m), fence, flight),
                 request.file);
      report.notes = fence.notes;
      break;
    }
    case RouteFormat::kQgcWaypoints:
      write_text(qgc_waypoints_text(mission_of(plan, flight, request.tolerance_m)), request.file);
      break;
    case RouteFormat::kDji:
      write_zip(wpml_files(plan, route, *flight), request.file);
      report.notes.emplace_back("the format has no word for spraying: switch it by hand or in the drone");
      break;
    case RouteFormat::kRobot: {
      const nlohmann::ordered_json json = ros_route(plan, route);
      const bool is_json = lower_case(request.file.extension().string()) == ".json";
      write_text(is_json ? json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"
                         : yaml_text(json),
                 request.file);
      break;
    }
  }
  return report;
}

}  // namespace tramline::io
