#pragma once
// The values of Rates one by one: what they are called in files and requests, and which are allowed.

#include <array>
#include <string>

#include "tramline/model/machine.h"

namespace tramline {

/// A number of Rates.
struct RateNumber {
  const char* key;  ///< "price_per_hour", in machine files, plan files and requests
  double Rates::*value;
  double least, most;
  bool whole;        ///< a number of things
  const char* unit;  ///< "€/h"
};

inline constexpr const char* kOperationKey = "operation";

inline constexpr std::array<RateNumber, 7> kRateNumbers{{
    {"price_per_hour", &Rates::price_per_hour, 0, 1e5, false, "€/h"},
    {"fuel_l_per_h", &Rates::fuel_l_per_h, 0, 1e4, false, "l/h"},
    {"fuel_price", &Rates::fuel_price, 0, 1e3, false, "€/l"},
    {"sections", &Rates::sections, 1, 1e4, true, "sections"},
    {"input_price_per_ha", &Rates::input_price_per_ha, 0, 1e6, false, "€/ha"},
    {"margin_per_ha", &Rates::margin_per_ha, 0, 1e6, false, "€/ha"},
    {"price_per_stop", &Rates::price_per_stop, 0, 1e5, false, "€"},
}};

/// With the work off an engine takes about so much of the fuel that it takes at work.
inline constexpr double kIdleFuelShare = 0.5;

/// The price of a second at work and of a second with the work off, in euros: machine, driver and fuel.
struct SecondPrices {
  double at_work = 0;
  double work_off = 0;
};
SecondPrices second_prices(const Rates& rates);

/// What a stop to back out costs, in seconds with the work off, of rates without negative numbers; 0 where
/// these cost nothing, and never more than kLongestStop_s, which is less than a way without room counts.
double stop_seconds(const Rates& rates);
inline constexpr double kLongestStop_s = 900;

/// Euros per m² of land worked twice, and of land missed, of rates without negative numbers (rates_of()).
inline double overlap_price_per_m2(const Rates& rates) {
  return rates.input_price_per_ha / rates.sections / 1e4;
}
inline double missed_price_per_m2(const Rates& rates) { return rates.margin_per_ha / 1e4; }

/// Width of the land under the wheels of a machine, m: two wheel tracks of 0.6 m.
inline constexpr double kWheelTracks_m = 1.2;
/// Euros per metre that leads over land of the tracks with the work off: the margin of the standing crop
/// under the wheels, 0 where the operation works none.
inline double driven_over_price_per_m(const Rates& rates) {
  return works_standing_crop(rates.operation) ? missed_price_per_m2(rates) * kWheelTracks_m : 0;
}
/// The same in seconds with the work off; 0 where these cost nothing.
double driven_over_seconds_per_m(const Rates& rates);

/// What is wrong with a value of this number, as the rest of a sentence after its name; empty where nothing
/// is. NaN and infinity are faults.
std::string fault_of(const RateNumber& number, double value);

/// What is wrong with any of the values that are given, a sentence that begins with its key; empty where
/// nothing is. O(1).
std::string rates_fault(const Rates& rates);

/// "seeding, spraying, …": the words of all operations.
std::string operation_words();

}  // namespace tramline
