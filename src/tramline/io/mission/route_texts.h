#pragma once
// The texts of files with a route, one function for each format.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tramline/io/export/file_set.h"
#include "tramline/io/machine/read_flight.h"
#include "tramline/io/mission/geofence.h"
#include "tramline/io/mission/mission_items.h"
#include "tramline/io/mission/way_points.h"
#include "tramline/model/coverage.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// A .plan of QGroundControl: SimpleItems, and the fence. Speeds for its estimate of time are the machine's.
std::string qgc_plan_text(const Plan& plan, const Mission& mission, const Geofence& fence,
                          const std::optional<Flight>& flight);

/// "QGC WPL 110": home, then the items, each a line of twelve columns.
std::string qgc_waypoints_text(const Mission& mission);

/// wpmz/template.kml and wpmz/waylines.wpml of a DJI mission. The format has no word for spraying. Throws
/// Error(kBadInput) where a speed, an altitude or the number of points is not one that it allows.
std::vector<NamedFile> wpml_files(const Plan& plan, const std::vector<WayPoint>& route, const Flight& flight);

/// GPX 1.1: one track of one segment.
std::string gpx_text(const Plan& plan, const std::vector<WayPoint>& route);

/// A line with a name, local metres.
struct NamedTrack {
  std::string name;
  std::vector<Point> points;
};

/// GPX 1.1: a place for each gap, named by its number, with its area, and its outline as a track; then the
/// tracks. Frame: `frame`, which is geodetic.
std::string gaps_gpx_text(const LocalFrame& frame, const std::vector<Gap>& gaps,
                          const std::vector<NamedTrack>& tracks);

/// The route for robots: `datum`, the place of the frame's origin; `path`, a nav_msgs/Path of all points;
/// `segments`, the exact stretches with type, gear, speed, curvature and work. Frame: x east, y north,
/// metres; yaw anticlockwise from east, rad.
nlohmann::ordered_json ros_route(const Plan& plan, const std::vector<WayPoint>& route);

/// Any JSON as YAML in block style, with a line break at its end. Numbers with a fraction have a point in
/// them, which YAML 1.1 asks for, and texts are in double quotes.
std::string yaml_text(const nlohmann::ordered_json& json);

}  // namespace tramline::io
