#include <nlohmann/json.hpp>

#include "tramline/geodesy/field_projection.h"
#include "tramline/io/mission/route_texts.h"

namespace tramline::io {
namespace {

using nlohmann::ordered_json;

// Of MAVLink (MAV_AUTOPILOT, MAV_TYPE) and of the file format.
constexpr int kArduPilot = 3, kQuadrotor = 2, kGroundRover = 10, kRelative = 1;

ordered_json item_json(const MissionItem& item, int number) {
  ordered_json params = ordered_json::array();
  for (const auto& value : item.params) params.push_back(value ? ordered_json(*value) : ordered_json());
  const bool place = item.frame == mavlink::kAboveHome;
  ordered_json out;
  if (place) {
    out["AMSLAltAboveTerrain"] = nullptr;
    out["Altitude"] = *item.params[6];
    out["AltitudeMode"] = kRelative;
  }
  out["autoContinue"] = true;
  out["command"] = item.command;
  out["doJumpId"] = number;
  out["frame"] = item.frame;
  out["params"] = params;
  out["type"] = "SimpleItem";
  return out;
}

ordered_json fence_json(const Geofence& fence, const LocalFrame& frame) {
  const FrameProjection projection(frame);
  ordered_json polygons = ordered_json::array();
  const auto add = [&](const std::vector<Ring>& rings, const char* side) {
    for (const Ring& ring : rings) {
      ordered_json corners = ordered_json::array();
      for (const Point corner : ring) {
        const Point lonlat = projection.to_lonlat(corner);
        corners.push_back({lonlat.y, lonlat.x});
      }
      polygons.push_back(
          {{"inclusion", side == std::string("inside")}, {"polygon", corners}, {"version", 1}});
    }
  };
  add(fence.stay_inside, "inside");
  add(fence.stay_outside, "outside");
  return {{"circles", ordered_json::array()}, {"polygons", polygons}, {"version", 2}};
}

}  // namespace

std::string qgc_plan_text(const Plan& plan, const Mission& mission, const Geofence& fence,
                          const std::optional<Flight>& flight) {
  ordered_json items = ordered_json::array();
  for (std::size_t i = 0; i < mission.items.size(); ++i)
    items.push_back(item_json(mission.items[i], static_cast<int>(i) + 1));
  const double speed_mps = plan.machine.turning.working_speed_mps;
  const ordered_json file = {{"fileType", "Plan"},
                             {"geoFence", fence_json(fence, plan.field.frame)},
                             {"groundStation", "QGroundControl"},
                             {"mission",
                              {{"cruiseSpeed", speed_mps},
                               {"firmwareType", kArduPilot},
                               {"globalPlanAltitudeMode", kRelative},
                               {"hoverSpeed", speed_mps},
                               {"items", items},
                               {"plannedHomePosition", {mission.home_lonlat.y, mission.home_lonlat.x, 0}},
                               {"vehicleType", flight ? kQuadrotor : kGroundRover},
                               {"version", 2}}},
                             {"rallyPoints", {{"points", ordered_json::array()}, {"version", 2}}},
                             {"version", 1}};
  return file.dump(2) + "\n";
}

}  // namespace tramline::io
