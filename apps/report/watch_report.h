#pragma once
// The report of `watch` during the drive, and at its end.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "report/evaluate_report.h"
#include "tramline/coverage/live/live_coverage.h"

namespace tramline::app {

/// The evaluation so far, with the data of a live one.
struct LiveFigures {
  Evaluation evaluation;
  bool final = false;
  bool settled = true;              ///< whether the figures are those of `evaluate`
  double present_m2_per_s = 0;      ///< NaN: not known
  double time_s = 0;                ///< of the last fix
  std::optional<bool> working;      ///< at the last fix
  std::optional<double> stalled_s;  ///< time without a fix, where that is too long
  bool work_key = false;            ///< whether the space key switches work
  bool looks_ahead = false;
  std::optional<coverage::Ahead> ahead;  ///< nullopt: not known
};

/// NaN: not known.
double present_ha_per_hour(const LiveFigures& live);
/// Time to work the missed land at the present rate, s; NaN: not known.
double remaining_s(const LiveFigures& live);
/// Keys: docs/json.md.
nlohmann::ordered_json live_json(const LiveFigures& live);
/// One line without its end.
std::string status_line(const LiveFigures& live);

}  // namespace tramline::app
