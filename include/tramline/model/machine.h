#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tramline {

/// How an implement is coupled: it turns with the machine, or follows it on a drawbar.
enum class Coupling { kMounted, kTowed };
const char* name(Coupling coupling);  ///< mounted, towed
std::optional<Coupling> coupling_named(std::string_view word);

/// What a machine needs to turn at the end of a track. Lengths in metres, along the machine, from the middle
/// of its rear axle. Without further word: a bar of the working width at the axle.
struct Turning {
  bool reverse = false;            ///< whether it may reverse between tracks
  double working_speed_mps = 2.5;  ///< 9 km/h
  double turning_speed_mps = 1.5;  ///< 5.4 km/h
  double reverse_speed_mps = 1;    ///< 3.6 km/h
  double gear_change_s = 3;        ///< to stop and start in the other gear
  double lift_m = 0;               ///< driven straight on after the work ends
  double lower_m = 0;              ///< driven straight before the work begins
  Coupling implement = Coupling::kMounted;
  double implement_offset_m = 0;  ///< from the axle back to the line where a mounted implement works, or to
                                  ///< the hitch of a towed one; negative: in front of the axle
  double drawbar_m = 0;           ///< of a towed implement: from the hitch to its axle, where it works
  double front_overhang_m = 0;    ///< of the vehicle, ahead of the axle
  double rear_overhang_m = 0;     ///< of the implement, behind the line where it works
  double vehicle_width_m = 0;
  double steering_time_s = 0;  ///< from straight ahead to the smallest circle; 0: at once

  bool operator==(const Turning& other) const = default;
};

/// Lengths in metres. width_m is the working width w, radius_m the least turning radius r of the axle.
struct Machine {
  std::string name;
  double width_m = 3;
  double radius_m = 6;
  double min_length_m = -1;  ///< shortest piece worth driving; negative: the default, 2 w (Versleijen §2.2.1)
  Turning turning{};
};

/// Machines that turn on the spot are planned as if this were the radius of their turns, m.
inline constexpr double kLeastRadius_m = 0.01;

inline double min_length_m(const Machine& machine) {
  return machine.min_length_m >= 0 ? machine.min_length_m : 2 * machine.width_m;
}

}  // namespace tramline
