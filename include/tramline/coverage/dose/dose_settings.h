#pragma once
// How it is found how much was applied where.

#include <limits>
#include <optional>
#include <string>

#include "tramline/coverage/evaluate_settings.h"
#include "tramline/geometry/angle.h"
#include "tramline/model/spray_pattern.h"

namespace tramline::coverage {

/// Where rates come from. Amounts of any unit.
struct RateSettings {
  double nominal_per_ha = std::numeric_limits<double>::quiet_NaN();
  /// Of a machine whose nozzles let out the same amount in a second however fast it drives; NaN: the rate is
  /// kept whatever the speed.
  double nominal_speed_mps = std::numeric_limits<double>::quiet_NaN();
  bool use_logged = true;  ///< logged rates win
};

/// A simple model (docs/dose.md). `share` of the amount is droplets so fine that they go with the wind: they
/// fall from the height of the nozzle at their terminal velocity – 0.27 m/s for droplets of 0.1 mm (Gunn and
/// Kinzer 1949, Journal of Meteorology 6:243–248) – and land wind · height / velocity downwind, spread
/// normally about that in every direction with `spread` of the shift as standard deviation. The rest lands
/// where it was laid.
struct WindSettings {
  double speed_mps = 0;
  Heading from;  ///< where it comes from
  double share = 0.05;
  double height_m = 0.5;
  double fall_mps = 0.27;
  double spread = 0.3;
};

struct DoseSettings {
  EvaluateSettings evaluate;  ///< engine and shapes are not looked at
  SprayPattern pattern;       ///< empty: even over the width
  std::string pattern_place;  ///< for messages
  RateSettings rates;
  double cell_m = 1;
  std::optional<WindSettings> wind;
};

}  // namespace tramline::coverage
