#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/interior_point.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/export/file_set.h"
#include "tramline/io/export/thinned_line.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/io/machine/read_flight.h"
#include "tramline/io/mission/route_texts.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/vector/lower_case.h"
#include "tramline/model/track.h"

namespace tramline::io {
namespace {

void require_a_route(const Plan& plan, const RouteRequest& request) {
  if (plan.route.planned()) return;
  if (is_repair(plan))
    throw bad_input(
        fmt::format("{}: a repair plan, such as that of field '{}', has tracks and no route; export it to "
                    ".gpx, .geojson or .kml, or for a terminal",
                    request.plan.string(), plan.field.id));
  throw bad_input(
      fmt::format("{}: the plan of field '{}' has tracks and no route; plan it again with --route",
                  request.plan.string(), plan.field.id));
}

void require_a_place(const LocalFrame& frame, const std::string& field, const RouteRequest& request) {
  if (!frame.geodetic && request.format != RouteFormat::kRobot)
    throw bad_input(
        fmt::format("{}: field '{}' is in plain metres, which have no place on the globe; only .yaml and "
                    ".json take it",
                    request.plan.string(), field));
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

RouteReport export_gaps_of_coverage(const RouteRequest& request) {
  if (request.format != RouteFormat::kGpx)
    throw bad_input(
        fmt::format("{}: the coverage of a drive has no route; export its gaps to .gpx, .geojson, .kml or "
                    ".zip, or for a terminal",
                    request.plan.string()));
  const Coverage coverage = read_coverage(request.plan);
  require_a_place(coverage.frame, coverage.field_id, request);
  if (coverage.gaps.empty())
    throw bad_input(
        fmt::format("{}: there are no gaps in it, so there is nothing to export", request.plan.string()));
  write_text(gaps_gpx_text(coverage.frame, coverage.gaps, {}), request.file);
  return {request.format, coverage.field_id, 0, 0, coverage.gaps.size(), {}};
}

/// The gaps that a repair plan works, and its passes in driving order.
RouteReport export_repair(const Plan& plan, const RouteRequest& request) {
  std::vector<Gap> gaps;
  for (const Polygon& shape : plan.body) {
    Gap& gap = gaps.emplace_back();
    gap.number = static_cast<int>(gaps.size());
    gap.shape = shape;
    gap.area_m2 = area(shape);
    gap.centre = interior_point(shape);
  }
  std::vector<NamedTrack> passes;
  for (const TrackPiece& piece : plan.pieces)
    passes.push_back({fmt::format("Pass {}", passes.size() + 1), chords(centre_line(piece))});
  write_text(gaps_gpx_text(plan.field.frame, gaps, passes), request.file);
  return {request.format, plan.field.id, 0, 0, gaps.size(), {}};
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
  if (is_coverage_file(request.plan)) return export_gaps_of_coverage(request);
  if (request.tolerance_m == 0)
    throw bad_input("--tolerance must be above 0 m for a route: its arcs become lines between points");
  const Plan plan = read_plan(request.plan, request.field);
  require_a_place(plan.field.frame, plan.field.id, request);
  if (request.format == RouteFormat::kGpx && is_repair(plan) && !plan.route.planned())
    return export_repair(plan, request);
  require_a_route(plan, request);
  const std::optional<Flight> flight = flight_of(request);
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
