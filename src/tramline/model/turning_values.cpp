#include "tramline/model/turning_values.h"

#include <fmt/format.h>

namespace tramline {
namespace {

struct AllowedNumbers {
  double least, most;
  bool above_least;  ///< the least itself is not allowed
  const char* unit;
};

/// Far above every machine there is: what is more was meant in another unit.
constexpr double kLongest_m = 100;
constexpr double kFastest_mps = 100;
constexpr double kSlowest_s = 600;

AllowedNumbers allowed_for(const TurningNumber& number) {
  switch (number.unit) {
    case TurningUnit::kMetresPerSecond:
      return {0, kFastest_mps, true, "m/s"};
    case TurningUnit::kSeconds:
      return {0, kSlowest_s, false, "s"};
    case TurningUnit::kMetres:
      break;
  }
  const bool behind_or_ahead = number.value == &Turning::implement_offset_m;
  return {behind_or_ahead ? -kLongest_m : 0, kLongest_m, false, "m"};
}

}  // namespace

std::string fault_of(const TurningNumber& number, double value) {
  const AllowedNumbers allowed = allowed_for(number);
  // Written so that NaN is a fault.
  const bool sound = value >= allowed.least && value <= allowed.most;
  if (sound && !(allowed.above_least && value == allowed.least)) return "";
  return fmt::format("is {:g}, but must be {} {:g} and at most {:g} {}", value,
                     allowed.above_least ? "more than" : "at least", allowed.least, allowed.most,
                     allowed.unit);
}

std::string drawbar_fault(const Turning& turning) {
  if (turning.implement == Coupling::kTowed && !(turning.drawbar_m > 0))
    return "is missing: a towed implement has a drawbar, from the hitch to its axle";
  if (turning.implement == Coupling::kMounted && turning.drawbar_m != 0)
    return fmt::format("is {:g}, but a mounted implement has no drawbar", turning.drawbar_m);
  return "";
}

std::string turning_fault(const Turning& turning) {
  for (const TurningNumber& number : kTurningNumbers)
    if (const std::string fault = fault_of(number, turning.*number.value); !fault.empty())
      return fmt::format("{} {}", number.key, fault);
  const std::string fault = drawbar_fault(turning);
  return fault.empty() ? "" : fmt::format("{} {}", kDrawbarKey, fault);
}

}  // namespace tramline
