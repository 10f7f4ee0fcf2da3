#pragma once
// The options of a plan as given by the user, and their values.

#include <array>
#include <optional>
#include <string>

#include "tramline/admission/read_guide.h"
#include "tramline/model/plan.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"

namespace tramline::app {

/// What the machine needs to turn, as typed; empty or unset where the user gave nothing.
struct TurningOptions {
  bool reverse = false;
  std::string implement;
  std::array<std::optional<double>, kTurningNumbers.size()> numbers{};  ///< in the order of kTurningNumbers
};

/// What the work of the machine costs, as typed; empty or unset where the user gave nothing.
struct RateOptions {
  std::string operation;
  std::array<std::optional<double>, kRateNumbers.size()> numbers{};  ///< in the order of kRateNumbers
};

/// The options as typed; empty or unset where the user gave none.
struct PlanOptions {
  std::optional<double> width_m, radius_m, min_length_m;
  TurningOptions turning;
  RateOptions rates;
  std::string machine_file;
  std::string like;  ///< a paper: what was not typed is as there (paper_conventions.h)
  std::string weights, prices, minimise;
  std::string strategy = "best";
  double direction_tolerance_deg = 0.01;
  bool prove = false;
  std::string end_rule;  ///< cheapest; with Zhou's tracks cover
  std::string boundary = "soft";
  std::string cell_direction = "rectangle";
  std::string avoid = "cheapest";
  std::optional<double> avoid_threshold_m, avoid_room_m;
  double clearance_m = 0;
  double merge_deg = 1;
  double decomposition_deg = 180;
  double short_edge_m = 0;
  std::string headlands = "0", obstacle_headlands = "0";  ///< a number of passes, or auto
  bool turns = false;
  std::string spacing = "adjacent";
  std::string route = "none";
  std::string order;  ///< best; without a route as spacing
  std::string headland_time = "last", pass_sequence = "any";
  std::string pass_corners = "auto";
  std::string start, end;  ///< of the route: "x,y", or a file
  std::optional<double> turn_room_m;
  double towing_error_m = 0.1;
  std::string ab, guide_file, guide_where, curved;
  std::string tracks = "parallel";
  std::string ab_anchor;  ///< line; with straight tracks as in Zhou envelope
};

/// "--turning-speed", the option for a number of kTurningNumbers.
std::string option_of(const TurningNumber& number);
/// "--price-per-hour", the option for a number of kRateNumbers.
std::string option_of(const RateNumber& number);
/// The machine file, overruled by --width, --radius, --min-length and the options for turning. Throws
/// kBadInput.
Machine machine_of(const PlanOptions& options);
/// --weights o,u,t[,s[,d]], --prices o,u,t[,s[,d]] or --minimise. Throws kBadInput.
Objective objective_of(const PlanOptions& options);
/// o,u,t[,s[,d]] as typed after `option`; prices of stops and further subfields that are not given are those
/// of `otherwise`. Throws kBadInput.
Objective prices_typed(const std::string& text, const char* option, const Objective& otherwise);
/// The line of --ab or --guide, if any; `crs` as --crs was typed or as the fields have it. Throws kBadInput.
std::optional<GuideLine> guide_of(const PlanOptions& options, const std::string& crs_definition);
/// The settings for one field: with the guide in its metres. A line with bends makes the tracks curved.
PlanSettings settings_for(const PlanSettings& settings, const std::optional<GuideLine>& guide,
                          const Field& field, const Machine& machine);
/// The gates of a route.
struct Gates {
  std::optional<GatePoints> start{};
  std::optional<GatePoints> end{};
};
/// Those of --start and --end, if any; `crs` as for guide_of(). Throws kBadInput.
Gates gates_of(const PlanOptions& options, const std::string& crs_definition);
/// Sets the gates of the settings to those nearest to the field. Throws kBadInput where none is near.
void place_gates(const Gates& gates, const Field& field, PlanSettings& settings);
/// What is wrong with --order as typed; empty where nothing.
std::string order_fault(const std::string& text);
/// What is wrong with --headlands or --obstacle-headlands as typed, or with --spacing; empty where nothing.
std::string headlands_fault(const std::string& text);
std::string spacing_fault(const std::string& text);
/// Throws kBadInput for an unknown word, and for an invalid threshold. Other ranges are checked by
/// validate_request().
PlanSettings settings_of(const PlanOptions& options);

}  // namespace tramline::app
