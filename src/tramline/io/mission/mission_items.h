#pragma once
// A route as a MAVLink mission, as ground stations and autopilots have it.

#include <array>
#include <optional>
#include <vector>

#include "tramline/io/machine/read_flight.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// Numbers of MAVLink (MAV_CMD, MAV_FRAME).
namespace mavlink {
inline constexpr int kWaypoint = 16, kReturnHome = 20, kLand = 21, kTakeOff = 22, kChangeSpeed = 178,
                     kSetServo = 183, kSetReverse = 194, kSprayer = 216;
inline constexpr int kAboveHome = 3;  ///< longitude, latitude, altitude above home
inline constexpr int kNoPlace = 2;    ///< a command that is about no place
}  // namespace mavlink

/// One item. Parameters 5 to 7 are latitude, longitude and altitude where it is about a place; those without
/// a value are left to the autopilot.
struct MissionItem {
  int command = mavlink::kWaypoint;
  int frame = mavlink::kAboveHome;
  std::array<std::optional<double>, 7> params{};
};

struct Mission {
  Point home_lonlat;  ///< where the route starts
  std::vector<MissionItem> items;
  std::size_t waypoints = 0;
};

/// The route as waypoints, with commands where speed, gear or work change. With a flight it begins by taking
/// off and ends by landing; without one it is that of a vehicle on the ground. Throws Error(kBadInput) where
/// there are more items than a mission may have (kMostItems). Preconditions: the plan has a route, in a
/// geodetic frame; tolerance_m > 0.
Mission mission_of(const Plan& plan, const std::optional<Flight>& flight, double tolerance_m);

/// Items are counted with sixteen bits, and the largest number is no item.
inline constexpr std::size_t kMostItems = 65535;

}  // namespace tramline::io
