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
constexpr double kSlowest_mps = 1, kFastest_mps = 15, kLowestTakeOff_m = 1.2, kHighest_m = 1500;
constexpr std::size_t kMostPoints = 65536;

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

std::string metres(double value) { return fmt::format("{:.2f}", value); }

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
  add(mission, "wpml:takeOffSecurityHeight", metres(flight.takeoff_altitude_m));
  add(mission, "wpml:globalTransitionalSpeed", metres(transit_mps));
}

void add_place(pugi::xml_node placemark, Point lonlat, std::size_t index) {
  add(placemark.append_child("Point"), "coordinates", fmt::format("{:.9f},{:.9f}", lonlat.x, lonlat.y));
  add(placemark, "wpml:index", std::to_string(index));
}

void add_heading_and_turn(pugi::xml_node parent, const char* heading, const char* turn) {
  add(parent.append_child(heading), "wpml:waypointHeadingMode", "followWayline");
  pugi::xml_node mode = parent.append_child(turn);
  add(mode, "wpml:waypointTurnMode", "toPointAndPassWithContinuityCurvature");
  add(mode, "wpml:waypointTurnDampingDist", "0");
}

std::string text_of(const pugi::xml_document& file) {
  std::ostringstream out;
  file.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

std::string template_text(const std::vector<Point>& places, const Plan& plan, const Flight& flight) {
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
  add(folder, "wpml:autoFlightSpeed", metres(plan.machine.turning.working_speed_mps));
  add(folder, "wpml:globalHeight", metres(flight.altitude_m));
  add(folder, "wpml:globalWaypointTurnMode", "toPointAndPassWithContinuityCurvature");
  add(folder, "wpml:globalUseStraightLine", "1");
  add(folder.append_child("wpml:globalWaypointHeadingParam"), "wpml:waypointHeadingMode", "followWayline");
  for (std::size_t i = 0; i < places.size(); ++i) {
    pugi::xml_node placemark = folder.append_child("Placemark");
    add_place(placemark, places[i], i);
    add(placemark, "wpml:ellipsoidHeight", metres(flight.altitude_m));
    add(placemark, "wpml:height", metres(flight.altitude_m));
    for (const char* global : {"wpml:useGlobalHeight", "wpml:useGlobalSpeed", "wpml:useGlobalHeadingParam",
                               "wpml:useGlobalTurnParam"})
      add(placemark, global, "1");
  }
  return text_of(file);
}

std::string waylines_text(const std::vector<Point>& places, const std::vector<WayPoint>& route,
                          const Plan& plan, const Flight& flight) {
  pugi::xml_document file;
  pugi::xml_node document = head_of(file);
  add_mission(document, flight, plan.machine.turning.turning_speed_mps);
  pugi::xml_node folder = document.append_child("Folder");
  add(folder, "wpml:templateId", "0");
  add(folder, "wpml:executeHeightMode", "relativeToStartPoint");
  add(folder, "wpml:waylineId", "0");
  add(folder, "wpml:autoFlightSpeed", metres(plan.machine.turning.working_speed_mps));
  for (std::size_t i = 0; i < places.size(); ++i) {
    pugi::xml_node placemark = folder.append_child("Placemark");
    add_place(placemark, places[i], i);
    add(placemark, "wpml:executeHeight", metres(flight.altitude_m));
    // The speed of a point is that with which the way from it is flown.
    add(placemark, "wpml:waypointSpeed", metres(route[std::min(i + 1, route.size() - 1)].speed_mps));
    add_heading_and_turn(placemark, "wpml:waypointHeadingParam", "wpml:waypointTurnParam");
    add(placemark, "wpml:useStraightLine", "1");
  }
  return text_of(file);
}

}  // namespace

std::vector<NamedFile> wpml_files(const Plan& plan, const std::vector<WayPoint>& route,
                                  const Flight& flight) {
  require_limits(plan, route, flight);
  const FrameProjection projection(plan.field.frame);
  std::vector<Point> places;
  for (const WayPoint& point : route) places.push_back(projection.to_lonlat(point.at));
  return {{"wpmz/template.kml", template_text(places, plan, flight)},
          {"wpmz/waylines.wpml", waylines_text(places, route, plan, flight)}};
}

}  // namespace tramline::io
