#pragma once
// What a machine file says of a machine that flies.

#include <array>
#include <filesystem>
#include <optional>

namespace tramline::io {

/// Where a drone lands when its mission is done: where it took off, or where its route ends.
enum class Landing { kHome, kEnd };

/// Altitudes are above the place where it takes off, m.
struct Flight {
  double altitude_m = 0;          ///< at work
  double takeoff_altitude_m = 0;  ///< to which it climbs first
  Landing landing = Landing::kHome;
  std::optional<int> spray_servo{};  ///< output that switches the spray; else the autopilot's own sprayer
};

/// The keys of a machine file that are about flight; other machines have none of them.
inline constexpr std::array<const char*, 4> kFlightKeys = {"flight_altitude_m", "takeoff_altitude_m",
                                                           "landing", "spray_servo"};

/// nullopt where the file has no flight_altitude_m. Throws Error(kBadInput) as read_machine(), and naming
/// file and line where a value is not one that drones have.
std::optional<Flight> read_flight(const std::filesystem::path& path);

}  // namespace tramline::io
