#pragma once
// Settings of dose maps.

#include <limits>
#include <optional>
#include <string>

#include "tramline/coverage/evaluate_settings.h"
#include "tramline/geometry/angle.h"
#include "tramline/model/dose_map.h"

namespace tramline::coverage {

/// The source of rates. Amounts are in any unit.
struct RateSettings {
  double nominal_per_ha = std::numeric_limits<double>::quiet_NaN();
  /// Speed at which the nominal rate holds, for a machine whose nozzles let out the same amount in a second
  /// however fast it drives; NaN: the machine keeps the rate at any speed.
  double nominal_speed_mps = std::numeric_limits<double>::quiet_NaN();
  bool use_logged = true;  ///< use logged rates where there are any
};

/// A simple model of drift (docs/dose.md). `share` of the amount is droplets so fine that they drift with the
/// wind: they fall from the height of the nozzle at their terminal velocity – 0.27 m/s for droplets of 0.1 mm
/// (Gunn and Kinzer 1949, Journal of Meteorology 6:243–248) – and land wind · height / velocity downwind,
/// spread normally about that in every direction with `spread` of the shift as standard deviation. The rest
/// lands where it is applied.
struct WindSettings {
  double speed_mps = 0;
  Heading from;  ///< direction the wind comes from
  double share = 0.05;
  double height_m = 0.5;
  double fall_mps = 0.27;
  double spread = 0.3;
};

struct DoseSettings {
  EvaluateSettings evaluate;  ///< engine and shapes are ignored
  SprayPattern pattern;       ///< empty: even over the width
  std::string pattern_place;  ///< name of the pattern's source, for messages
  RateSettings rates;
  double cell_m = 1;
  std::optional<WindSettings> wind;
};

}  // namespace tramline::coverage
