#include "tramline/io/mission/mission_items.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"
#include "tramline/io/mission/way_points.h"

namespace tramline::io {
namespace {

/// Pulses of a servo at its two ends, µs.
constexpr double kServoOn_us = 1900, kServoOff_us = 1100;
/// MAV_CMD_DO_CHANGE_SPEED: speed over ground, throttle unchanged.
constexpr double kGroundSpeed = 1, kThrottleUnchanged = -1;

/// Appends items; remembers speed, gear and work to write them only where they change.
class ItemList {
 public:
  ItemList(const Plan& plan, const std::optional<Flight>& flight)
      : projection_(plan.field.frame), flight_(flight) {}

  void take_off(Point at) {
    if (flight_) add_place(mavlink::kTakeOff, at, flight_->takeoff_altitude_m);
  }

  void go_to(const WayPoint& point) {
    if (point.work != work_) switch_work(point.work ? Work::kOn : Work::kOff);
    if (!flight_ && point.gear != gear_) {
      gear_ = point.gear;
      add_command(mavlink::kSetReverse, gear_ == Gear::kReverse ? 1 : 0, 0, 0);
    }
    if (point.speed_mps != speed_mps_) {
      speed_mps_ = point.speed_mps;
      add_command(mavlink::kChangeSpeed, kGroundSpeed, speed_mps_, kThrottleUnchanged);
    }
    add_place(mavlink::kWaypoint, point.at, flight_ ? flight_->altitude_m : 0);
    ++mission_.waypoints;
  }

  void end(const WayPoint& last) {
    if (work_) switch_work(Work::kOff);
    if (!flight_) return;
    if (flight_->landing == Landing::kEnd)
      add_place(mavlink::kLand, last.at, 0);
    else
      add_command(mavlink::kReturnHome, 0, 0, 0);
  }

  Mission done(Point home) && {
    mission_.home_lonlat = projection_.to_lonlat(home);
    return std::move(mission_);
  }

 private:
  enum class Work { kOff, kOn };

  void switch_work(Work state) {
    work_ = state == Work::kOn;
    if (flight_ && flight_->spray_servo)
      add_command(mavlink::kSetServo, *flight_->spray_servo, work_ ? kServoOn_us : kServoOff_us, 0);
    else
      add_command(mavlink::kSprayer, work_ ? 1 : 0, 0, 0);
  }

  void add_command(int command, double first, double second, double third) {
    mission_.items.push_back({command, mavlink::kNoPlace, {first, second, third, 0, 0, 0, 0}});
  }

  /// The heading on arrival is left to the autopilot: it follows the way.
  void add_place(int command, Point at, double altitude_m) {
    const Point lonlat = projection_.to_lonlat(at);
    mission_.items.push_back(
        {command, mavlink::kAboveHome, {0, 0, 0, std::nullopt, lonlat.y, lonlat.x, altitude_m}});
  }

  FrameProjection projection_;
  const std::optional<Flight>& flight_;
  Mission mission_;
  double speed_mps_ = -1;
  Gear gear_ = Gear::kForward;
  bool work_ = false;
};

}  // namespace

Mission mission_of(const Plan& plan, const std::optional<Flight>& flight, double tolerance_m) {
  assert(plan.route.planned() && plan.field.frame.geodetic && tolerance_m > 0);
  const std::vector<WayPoint> points = way_points(plan, tolerance_m);
  ItemList list(plan, flight);
  list.take_off(points.front().at);
  // Each point says how the way to it is driven; nothing is worked on the way to the first.
  WayPoint first = points.front();
  first.work = false;
  list.go_to(first);
  for (std::size_t i = 1; i < points.size(); ++i) list.go_to(points[i]);
  list.end(points.back());
  Mission out = std::move(list).done(points.front().at);
  if (out.items.size() > kMostItems)
    throw bad_input(
        fmt::format("the route has {} items, and a mission {} at most; export it with a larger --tolerance",
                    out.items.size(), kMostItems));
  return out;
}

}  // namespace tramline::io
