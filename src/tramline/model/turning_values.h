#pragma once
// The values of Turning one by one: what they are called in files and requests, and which are allowed.

#include <array>
#include <string>

#include "tramline/model/machine.h"

namespace tramline {

enum class TurningUnit { kMetres, kMetresPerSecond, kSeconds };

/// A number of Turning.
struct TurningNumber {
  const char* key;  ///< "working_speed_mps", in machine files, plan files and requests
  double Turning::*value;
  TurningUnit unit;
};

inline constexpr const char* kReverseKey = "reverse";
inline constexpr const char* kImplementKey = "implement";
inline constexpr const char* kDrawbarKey = "drawbar_m";

/// All numbers; `reverse` and `implement` are the values of Turning that are none.
inline constexpr std::array<TurningNumber, 12> kTurningNumbers{{
    {"working_speed_mps", &Turning::working_speed_mps, TurningUnit::kMetresPerSecond},
    {"turning_speed_mps", &Turning::turning_speed_mps, TurningUnit::kMetresPerSecond},
    {"reverse_speed_mps", &Turning::reverse_speed_mps, TurningUnit::kMetresPerSecond},
    {"gear_change_s", &Turning::gear_change_s, TurningUnit::kSeconds},
    {"steering_time_s", &Turning::steering_time_s, TurningUnit::kSeconds},
    {"lift_m", &Turning::lift_m, TurningUnit::kMetres},
    {"lower_m", &Turning::lower_m, TurningUnit::kMetres},
    {"implement_offset_m", &Turning::implement_offset_m, TurningUnit::kMetres},
    {kDrawbarKey, &Turning::drawbar_m, TurningUnit::kMetres},
    {"front_overhang_m", &Turning::front_overhang_m, TurningUnit::kMetres},
    {"rear_overhang_m", &Turning::rear_overhang_m, TurningUnit::kMetres},
    {"vehicle_width_m", &Turning::vehicle_width_m, TurningUnit::kMetres},
}};

/// What is wrong with a value of this number, as the rest of a sentence after its name, "is 0, but must be
/// more than 0 and at most 100 m/s"; empty where nothing is. Speeds are above 0; only the offset of an
/// implement may be negative. NaN and infinity are faults.
std::string fault_of(const TurningNumber& number, double value);

/// What is wrong with the drawbar of an implement coupled this way, as fault_of(): a towed implement has one,
/// a mounted one none.
std::string drawbar_fault(const Turning& turning);

/// What is wrong with any of the values, a sentence that begins with its key; empty where nothing is. O(1).
std::string turning_fault(const Turning& turning);

}  // namespace tramline
