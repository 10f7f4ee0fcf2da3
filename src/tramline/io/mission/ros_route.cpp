#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tramline/io/mission/route_texts.h"
#include "tramline/model/plain_zero.h"
#include "tramline/model/speeds.h"

namespace tramline::io {
namespace {

using nlohmann::ordered_json;

constexpr const char* kFrame = "field";

/// Anticlockwise from east, in (-π, π].
double yaw_of(Heading heading) {
  return std::remainder(std::numbers::pi / 2 - heading.angle().radians(), 2 * std::numbers::pi);
}

ordered_json header() { return {{"stamp", {{"sec", 0}, {"nanosec", 0}}}, {"frame_id", kFrame}}; }

ordered_json pose_stamped(const WayPoint& point) {
  const double half = 0.5 * yaw_of(point.heading);
  return {{"header", header()},
          {"pose",
           {{"position", {{"x", plain_zero(point.at.x)}, {"y", plain_zero(point.at.y)}, {"z", 0.0}}},
            {"orientation", {{"x", 0.0}, {"y", 0.0}, {"z", std::sin(half)}, {"w", std::cos(half)}}}}}};
}

ordered_json pose_json(const Pose& pose) {
  return {{"x", plain_zero(pose.at.x)}, {"y", plain_zero(pose.at.y)}, {"yaw", yaw_of(pose.heading)}};
}

const char* type_of(const SteeredStretch& stretch) {
  if (stretch.clothoid()) return "clothoid";
  return stretch.curvature_at_start == 0 ? "line" : "arc";
}

ordered_json segment_json(const RouteLeg& leg, const SteeredStretch& stretch, const Turning& turning) {
  return {{"type", type_of(stretch)},
          {"leg", name(leg.kind)},
          {"gear", name(stretch.gear)},
          {"work", leg.work},
          {"speed_mps", speed_of(leg, turning)},
          {"length_m", stretch.length_m},
          {"curvature_at_start", plain_zero(stretch.curvature_at_start)},
          {"curvature_at_end", plain_zero(stretch.curvature_at_end)},
          {"start", pose_json(stretch.start)},
          {"end", pose_json(end_of(stretch))}};
}

/// A field in plain metres has no place on the globe, and its origin one in its file's plane.
ordered_json datum_json(const LocalFrame& frame) {
  if (!frame.geodetic) return {{"x_m", frame.origin_x_m}, {"y_m", frame.origin_y_m}};
  return {{"latitude_deg", frame.origin_lat_deg},
          {"longitude_deg", frame.origin_lon_deg},
          {"projection", "transverse Mercator, WGS 84, scale 1, centred on the datum"}};
}

}  // namespace

ordered_json ros_route(const Plan& plan, const std::vector<WayPoint>& route) {
  ordered_json poses = ordered_json::array();
  for (const WayPoint& point : route) poses.push_back(pose_stamped(point));
  ordered_json segments = ordered_json::array();
  for (const RouteLeg& leg : plan.route.legs)
    for (const SteeredStretch& stretch : leg.path)
      if (stretch.length_m > 0) segments.push_back(segment_json(leg, stretch, plan.machine.turning));
  return {{"field", plan.field.id},
          {"frame_id", kFrame},
          {"datum", datum_json(plan.field.frame)},
          {"path", {{"header", header()}, {"poses", poses}}},
          {"segments", segments}};
}

}  // namespace tramline::io
