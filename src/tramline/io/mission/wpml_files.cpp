#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/time_stamp.h"
#include "tramline/io/mission/route_texts.h"

namespace tramline::io {
namespace {

// Limits of the format: metres a second, metres, and the number of points, which are counted from 0 to 65535.
constexpr double kSlowest_mps = 1, kFastest_mps = 15, kLowestTakeOff_m = 1.2, kLowestReturn_m = 2,
                 kHighest_m = 1500;
constexpr std::size_t kMostPoints = 65536;
/// A drone that passes a point leaves its line so far before it, m, but for a share of the shorter way beside
/// the point: those of two points may not meet. A chord deviates from its arc by more than such a corner.
constexpr double kMostDamping_m = 0.2, kDampedShare = 0.4;
constexpr const char* kPassing = "toPointAndPassWithContinuityCurvature";

/// Climbing less than this before the mission begins is not allowed, so a lower take-off is refused.
void require_limits(const Plan& plan, const std::vector<WayPoint>& route, const Flight& flight) {
  for (const WayPoint& point : route)
    if (!(point.speed_mps >= kSlowest_mps && point.speed_mps <= kFastest_mps))
      throw bad_input(
          fmt::format("the route of field '{}' has a speed of {} m/s, and DJI drones take {} to {} m/s; "
                      "change working_speed_mps, "
                      "turning_speed_mps or reverse_speed_mps of the machine and plan again",
                      plan.field.id, point.speed_mps, kSlowest_mps, kFastest_mps));
  if (!(flight.takeoff_altitude_m >= kLowestTakeOff_m && flight.takeoff_altitude_m <= kHighest_m))
    throw bad_input(fmt::format("takeoff_altitude_m is {} m, and DJI drones climb to {} to {} m first",
                                flight.takeoff_altitude_m, kLowestTakeOff_m, kHighest_m));
  if (route.size() > kMostPoints)
    throw bad_input(fmt::format(
        "the route has {} points, and a DJI mission {} at most; export it with a larger --tolerance",
        route.size(), kMostPoints));
}

void add(pugi::xml_node parent, const char* name, const std::string& text) {
  parent.append_child(name).text() = text.c_str();
}

/// Metres, metres a second or seconds.
std::string two_decimals(double value) { return fmt::format("{:.2f}", value); }

/// The head of either file; returns its Document.
pugi::xml_node head_of(pugi::xml_document& file) {
  pugi::xml_node declaration = file.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = file.append_child("kml");
  root.append_attribute("xmlns") = "http://www.opengis.net/kml/2.2";
  root.append_attribute("xmlns:wpml") = "http://www.dji.com/wpmz/1.0.2";
  return root.append_child("Document");
}

void add_mission(pugi::xml_node document, const Flight& flight, double transit_mps) {
  pugi::xml_node mission = document.append_child("wpml:missionConfig");
  add(mission, "wpml:flyToWaylineMode", "safely");
  add(mission, "wpml:finishAction", flight.landing == Landing::kEnd ? "autoLand" : "goHome");
  add(mission, "wpml:exitOnRCLost", "executeLostAction");
  add(mission, "wpml:executeRCLostAction", "goBack");
  add(mission, "wpml:takeOffSecurityHeight", two_decimals(flight.takeoff_altitude_m));
  add(mission, "wpml:globalTransitionalSpeed", two_decimals(transit_mps));
  add(mission, "wpml:globalRTHHeight",
      two_decimals(std::max({kLowestReturn_m, flight.altitude_m, flight.takeoff_altitude_m})));
}

void add_place(pugi::xml_node placemark, Point lonlat, std::size_t index) {
  add(placemark.append_child("Point"), "coordinates", fmt::format("{:.9f},{:.9f}", lonlat.x, lonlat.y));
  add(placemark, "wpml:index", std::to_string(index));
}

void add_heading(pugi::xml_node parent, const char* element) {
  pugi::xml_node heading = parent.append_child(element);
  add(heading, "wpml:waypointHeadingMode", "followWayline");
  add(heading, "wpml:waypointHeadingPathMode", "followBadArc");  // the shorter way round
}

void add_turn(pugi::xml_node placemark, double damping_m) {
  pugi::xml_node turn = placemark.append_child("wpml:waypointTurnParam");
  add(turn, "wpml:waypointTurnMode", kPassing);
  add(turn, "wpml:waypointTurnDampingDist", fmt::format("{:.4f}", damping_m));
  add(placemark, "wpml:useStraightLine", "1");
}

/// A point as both files have it.
struct DjiPoint {
  Point lonlat;
  double speed_mps = 0;  ///< with which the way from it is flown
  double damping_m = 0;
};

std::vector<DjiPoint> dji_points(const std::vector<WayPoint>& route, const LocalFrame& frame) {
  const FrameProjection projection(frame);
  std::vector<DjiPoint> out;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const std::size_t next = std::min(i + 1, route.size() - 1), before = i > 0 ? i - 1 : next;
    double beside_m = distance(route[i].at, route[before].at);
    if (next > i) beside_m = std::min(beside_m, distance(route[i].at, route[next].at));
    // Of a way point the speed is that of the way to it.
    out.push_back({projection.to_lonlat(route[i].at), route[next].speed_mps,
                   std::min(kMostDamping_m, kDampedShare * beside_m)});
  }
  return out;
}

double seconds_of(const std::vector<WayPoint>& route) {
  double out = 0;
  for (std::size_t i = 1; i < route.size(); ++i)
    out += distance(route[i - 1].at, route[i].at) / route[i].speed_mps;
  return out;
}

std::string text_of(const pugi::xml_document& file) {
  std::ostringstream out;
  file.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

std::string template_text(const std::vector<DjiPoint>& points, const Plan& plan, const Flight& flight) {
  pugi::xml_document file;
  pugi::xml_node document = head_of(file);
  const std::string time_ms = fmt::format("{}", static_cast<long long>(time_of_files()) * 1000);
  add(document, "wpml:author", "tramline");
  add(document, "wpml:createTime", time_ms);
  add(document, "wpml:updateTime", time_ms);
  add_mission(document, flight, plan.machine.turning.turning_speed_mps);
  pugi::xml_node folder = document.append_child("Folder");
  add(folder, "wpml:templateType", "waypoint");
  add(folder, "wpml:templateId", "0");
  pugi::xml_node system = folder.append_child("wpml:waylineCoordinateSysParam");
  add(system, "wpml:coordinateMode", "WGS84");
  add(system, "wpml:heightMode", "relativeToStartPoint");
  add(folder, "wpml:autoFlightSpeed", two_decimals(plan.machine.turning.working_speed_mps));
  add(folder, "wpml:gimbalPitchMode", "manual");
  add(folder, "wpml:globalHeight", two_decimals(flight.altitude_m));
  add(folder, "wpml:globalWaypointTurnMode", kPassing);
  add(folder, "wpml:globalUseStraightLine", "1");
  add_heading(folder, "wpml:globalWaypointHeadingParam");
  for (std::size_t i = 0; i < points.size(); ++i) {
    pugi::xml_node placemark = folder.append_child("Placemark");
    add_place(placemark, points[i].lonlat, i);
    add(placemark, "wpml:ellipsoidHeight", two_decimals(flight.altitude_m));
    add(placemark, "wpml:height", two_decimals(flight.altitude_m));
    add(placemark, "wpml:useGlobalHeight", "1");
    add(placemark, "wpml:useGlobalSpeed", "0");
    add(placemark, "wpml:waypointSpeed", two_decimals(points[i].speed_mps));
    add(placemark, "wpml:useGlobalHeadingParam", "1");
    add(placemark, "wpml:useGlobalTurnParam", "0");
    add_turn(placemark, points[i].damping_m);
  }
  return text_of(file);
}

std::string waylines_text(const std::vector<DjiPoint>& points, const std::vector<WayPoint>& route,
                          const Plan& plan, const Flight& flight) {
  pugi::xml_document file;
  pugi::xml_node document = head_of(file);
  add_mission(document, flight, plan.machine.turning.turning_speed_mps);
  pugi::xml_node folder = document.append_child("Folder");
  add(folder, "wpml:templateId", "0");
  add(folder, "wpml:executeHeightMode", "relativeToStartPoint");
  add(folder, "wpml:waylineId", "0");
  add(folder, "wpml:distance", two_decimals(length_of(route)));
  add(folder, "wpml:duration", two_decimals(seconds_of(route)));
  add(folder, "wpml:autoFlightSpeed", two_decimals(plan.machine.turning.working_speed_mps));
  for (std::size_t i = 0; i < points.size(); ++i) {
    pugi::xml_node placemark = folder.append_child("Placemark");
    add_place(placemark, points[i].lonlat, i);
    add(placemark, "wpml:executeHeight", two_decimals(flight.altitude_m));
    add(placemark, "wpml:waypointSpeed", two_decimals(points[i].speed_mps));
    add_heading(placemark, "wpml:waypointHeadingParam");
    add_turn(placemark, points[i].damping_m);
  }
  return text_of(file);
}

}  // namespace

std::vector<NamedFile> wpml_files(const Plan& plan, const std::vector<WayPoint>& route,
                                  const Flight& flight) {
  require_limits(plan, route, flight);
  const std::vector<DjiPoint> points = dji_points(route, plan.field.frame);
  return {{"wpmz/template.kml", template_text(points, plan, flight)},
          {"wpmz/waylines.wpml", waylines_text(points, route, plan, flight)}};
}

}  // namespace tramline::io
