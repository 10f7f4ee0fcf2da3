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

/// What a machine does on a field. It decides the usual prices and the usual speed at work.
enum class Operation {
  kGeneral,
  kSeeding,
  kSpraying,
  kSpreading,
  kTillage,
  kMowing,
  kHarvest,
  kWeeding,  ///< by a robot
  kDrone     ///< spraying from the air
};
/// general, seeding, spraying, spreading, tillage, mowing, harvest, robot weeding, drone
const char* name(Operation operation);
std::optional<Operation> operation_named(std::string_view word);
/// docs/machine.md says where it is from; of kGeneral the default of Turning.
double usual_speed_mps(Operation operation);

/// What the work of a machine costs, in euros. A negative number stands for what is usual for the operation.
struct Rates {
  Operation operation = Operation::kGeneral;
  double price_per_hour = -1;      ///< of machine and driver, without fuel
  double fuel_l_per_h = -1;        ///< at work; half of it with the work off
  double fuel_price = -1;          ///< per litre
  double sections = -1;            ///< that switch off by themselves where the land is worked already
  double input_price_per_ha = -1;  ///< seed, spray or fertiliser, which land worked twice gets twice
  double margin_per_ha = -1;       ///< lost where land is missed, and where standing crop is driven over
  double price_per_stop = -1;      ///< of backing out of an end without a way off, besides its time

  bool operator==(const Rates& other) const = default;
};

/// Lengths in metres. width_m is the working width w, radius_m the least turning radius r of the axle.
struct Machine {
  std::string name;
  double width_m = 3;
  double radius_m = 6;
  double min_length_m = -1;  ///< shortest piece worth driving; negative: the default, 2 w (Versleijen §2.2.1)
  Turning turning{};
  Rates rates{};
};

/// The machine's rates with what is usual for its operation in the place of negative numbers.
Rates rates_of(const Machine& machine);
/// Whether what the operation works on stands as a crop: then driving over it costs.
bool works_standing_crop(Operation operation);

/// Machines that turn on the spot are planned as if this were the radius of their turns, m.
inline constexpr double kLeastRadius_m = 0.01;

/// How far corners of the vehicle and of a mounted implement swing out of the band of the working width on
/// the smallest circle, m: by so much at the least the machine leaves the land where it turns away from an
/// edge beside which it works. 0 for a bar at the axle. Precondition: width_m > 0. O(1).
double corner_swing_m(const Machine& machine);

inline double min_length_m(const Machine& machine) {
  return machine.min_length_m >= 0 ? machine.min_length_m : 2 * machine.width_m;
}

}  // namespace tramline
