#include "request/plan_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/geometry/path/kinked_offset.h"
#include "tramline/io/land/read_fields.h"
#include "tramline/io/machine/read_machine.h"
#include "tramline/io/vector/read_vector.h"
#include "tramline/model/limits.h"
#include "tramline/planner/validate_request.h"

namespace tramline::app {
namespace {

/// "0.02,0.1,1" as numbers.
std::vector<double> numbers_in(const std::string& text, const char* option) {
  std::vector<double> out;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::string word = text.substr(from, comma - from);
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value) || value < 0)
      throw bad_input(
          fmt::format("{} takes numbers of at least 0 separated by commas, and '{}' in '{}' is not one",
                      option, word, text));
    out.push_back(value);
    from = comma + 1;
  }
  if (out.size() < 3 || out.size() > 5)
    throw bad_input(fmt::format(
        "{} takes three to five numbers, overlap,uncovered,turn[,stop[,subfield]], not '{}'", option, text));
  return out;
}

Scenario scenario_named(const std::string& word) {
  if (word == "overlap") return Scenario::kOverlap;
  if (word == "uncovered") return Scenario::kUncovered;
  if (word == "turns") return Scenario::kTurns;
  throw bad_input(fmt::format("--minimise takes overlap, uncovered or turns, not '{}'", word));
}

template <class Choice>
Choice chosen(std::optional<Choice> choice, const char* option, const std::string& word, const char* words) {
  if (!choice) throw bad_input(fmt::format("{} takes {}, not '{}'", option, words, word));
  return *choice;
}

TrackShape shape_of(const std::string& curved) {
  if (curved.empty() || curved == "never") return TrackShape::kStraight;
  if (curved == "auto") return TrackShape::kAuto;
  if (curved == "always") return TrackShape::kCurved;
  throw bad_input(fmt::format("--curved takes auto, always or never, not '{}'", curved));
}

/// As many numbers as there are, parted by commas and spaces; none where anything else is in the text.
std::vector<double> coordinates_in(const std::string& text) {
  std::vector<double> out;
  const char* at = text.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at || !std::isfinite(value)) break;
    out.push_back(value);
    at = end;
    while (*at == ',' || *at == ' ') ++at;
  }
  if (*at != '\0') out.clear();
  return out;
}

/// "x1,y1 x2,y2"
std::vector<double> four_numbers(const std::string& text) {
  std::vector<double> out = coordinates_in(text);
  if (out.size() != 4) throw bad_input(fmt::format("--ab takes two points, \"x1,y1 x2,y2\", not '{}'", text));
  return out;
}

/// A negative number would be taken for the default, which is not what was typed.
double length_typed(double value, const char* what) {
  require_metres(value, 0, kFarthest_m, what);
  return value;
}

constexpr int kMostPasses = 100, kMostSkipped = 1000;
constexpr const char* kAuto = "auto";

/// A whole number within the range; nullopt for any other text.
std::optional<int> count_typed(std::string_view text, int least, int most) {
  int value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size() || value < least || value > most)
    return std::nullopt;
  return value;
}

/// "adjacent", "skip 4" or "4".
std::optional<int> jump_typed(std::string_view text) {
  if (text == "adjacent") return 1;
  constexpr std::string_view kSkip = "skip";
  if (text.starts_with(kSkip)) {
    text.remove_prefix(kSkip.size());
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  return count_typed(text, 1, kMostSkipped);
}

int passes_typed(const std::string& text, const char* option) {
  if (const std::string fault = headlands_fault(text); !fault.empty())
    throw bad_input(fmt::format("{} {}", option, fault));
  return count_typed(text, 0, kMostPasses).value_or(0);
}

HeadlandRule rule_typed(const std::string& text) {
  return text == kAuto ? HeadlandRule::kTurns : HeadlandRule::kPasses;
}

void set_headlands(const PlanOptions& o, PlanSettings& settings) {
  settings.headlands = passes_typed(o.headlands, "--headlands");
  settings.obstacle_headlands = passes_typed(o.obstacle_headlands, "--obstacle-headlands");
  settings.headland_rule = rule_typed(o.headlands);
  settings.obstacle_headland_rule = rule_typed(o.obstacle_headlands);
}

/// `turning` overruled by what was typed. A machine file's drawbar does not outlast its towed implement.
Turning turning_typed(const TurningOptions& typed, const Turning& turning) {
  Turning out = turning;
  out.reverse = out.reverse || typed.reverse;
  if (!typed.implement.empty()) {
    const auto coupling = coupling_named(typed.implement);
    if (!coupling)
      throw bad_input(fmt::format("--implement takes mounted or towed, not '{}'", typed.implement));
    out.implement = *coupling;
    if (*coupling == Coupling::kMounted) out.drawbar_m = 0;
  }
  for (std::size_t i = 0; i < kTurningNumbers.size(); ++i) {
    if (!typed.numbers[i]) continue;
    const TurningNumber& number = kTurningNumbers[i];
    if (const std::string fault = fault_of(number, *typed.numbers[i]); !fault.empty())
      throw bad_input(fmt::format("{} {}", option_of(number), fault));
    out.*number.value = *typed.numbers[i];
  }
  if (const std::string fault = drawbar_fault(out); !fault.empty())
    throw bad_input(fmt::format("--drawbar {}", fault));
  return out;
}

/// `machine` with what was typed about its operation and its prices. The speed is then the one usual for that
/// operation, unless it is typed too.
Machine with_rates_typed(const PlanOptions& o, Machine machine) {
  const RateOptions& typed = o.rates;
  if (!typed.operation.empty()) {
    const auto operation = operation_named(typed.operation);
    if (!operation)
      throw bad_input(
          fmt::format("--operation takes one of {}, not '{}'", operation_words(), typed.operation));
    machine.rates.operation = *operation;
    machine.turning.working_speed_mps = usual_speed_mps(*operation);
  }
  for (std::size_t i = 0; i < kRateNumbers.size(); ++i) {
    if (!typed.numbers[i]) continue;
    const RateNumber& number = kRateNumbers[i];
    if (const std::string fault = fault_of(number, *typed.numbers[i]); !fault.empty())
      throw bad_input(fmt::format("{} {}", option_of(number), fault));
    machine.rates.*number.value = *typed.numbers[i];
  }
  return machine;
}

/// "x,y" or the points of a file; nothing where nothing was typed.
std::optional<GatePoints> gate_of(const std::string& text, const char* option,
                                  const std::string& crs_definition) {
  if (text.empty()) return std::nullopt;
  const std::vector<double> numbers = coordinates_in(text);
  if (numbers.size() == 2) return gate_of_point({numbers[0], numbers[1]}, option, crs_definition);
  if (!numbers.empty())
    throw bad_input(fmt::format("{} takes a point, \"x,y\", or a file of points, not '{}'", option, text));
  io::VectorQuery query;
  query.file = text;
  query.all_layers = true;
  return read_gates(io::read_vector(query), crs_definition);
}

/// Whether the user has said what tracks are to cost, or plans as a paper does.
bool is_priced_otherwise(const PlanOptions& o) {
  return !(o.weights.empty() && o.prices.empty() && o.minimise.empty() && o.like.empty());
}

constexpr const char* kBestOrder = "best";
constexpr const char* kRoute = "whole";

TurnPlanning turns_typed(const PlanOptions& o, const PlanSettings& settings) {
  if (o.route.empty() || o.route == kRoute) return TurnPlanning::kRoute;
  if (o.route != "none") throw bad_input(fmt::format("--route takes whole or none, not '{}'", o.route));
  const bool follow = settings.headland_rule == HeadlandRule::kTurns ||
                      settings.obstacle_headland_rule == HeadlandRule::kTurns;
  return o.turns || follow ? TurnPlanning::kTurns : TurnPlanning::kNone;
}

/// The order of tracks: `skip` is that of --order where it names one, else that of --spacing.
void set_order(const PlanOptions& o, PlanSettings& settings) {
  if (const std::string fault = spacing_fault(o.spacing); !fault.empty())
    throw bad_input(fmt::format("--spacing {}", fault));
  settings.skip = jump_typed(o.spacing).value_or(1);
  if (o.order.empty() || o.order == kBestOrder) return;
  if (const std::string fault = order_fault(o.order); !fault.empty())
    throw bad_input(fmt::format("--order {}", fault));
  settings.skip = jump_typed(o.order).value_or(1);
  settings.route.order = TrackOrder::kBySpacing;
}

void set_avoidance(const PlanOptions& o, PlanSettings& settings) {
  settings.avoid = chosen(avoidance_named(o.avoid), "--avoid", o.avoid, "cheapest, paper or cut");
  if (settings.avoid != Avoidance::kPaper && (o.avoid_threshold_m || o.avoid_room_m))
    throw bad_input(fmt::format("{} belongs to --avoid paper: give that too, or leave it out",
                                o.avoid_threshold_m ? "--avoid-threshold" : "--avoid-room"));
  if (o.avoid_threshold_m) settings.avoid_threshold_m = length_typed(*o.avoid_threshold_m, kAvoidThreshold);
  if (o.avoid_room_m) settings.avoid_room_m = length_typed(*o.avoid_room_m, kAvoidRoom);
  settings.clearance_m = o.clearance_m;
}

}  // namespace

std::string order_fault(const std::string& text) {
  if (text == kBestOrder || jump_typed(text)) return "";
  return fmt::format("takes 'best', 'adjacent', or 'skip K' with a number of tracks from 1 to {}, not '{}'",
                     kMostSkipped, text);
}

std::string headlands_fault(const std::string& text) {
  if (text == kAuto || count_typed(text, 0, kMostPasses)) return "";
  return fmt::format("takes a number of passes from 0 to {}, or auto, not '{}'", kMostPasses, text);
}

std::string spacing_fault(const std::string& text) {
  if (jump_typed(text)) return "";
  return fmt::format("takes 'adjacent', or 'skip K' with a number of tracks from 1 to {}, not '{}'",
                     kMostSkipped, text);
}

std::string option_of(const TurningNumber& number) {
  const std::string key = number.key;
  std::string out = "--" + key.substr(0, key.rfind('_'));  // without its unit
  std::replace(out.begin(), out.end(), '_', '-');
  return out;
}

std::string option_of(const RateNumber& number) {
  std::string out = std::string("--") + number.key;
  std::replace(out.begin(), out.end(), '_', '-');
  return out;
}

std::optional<GuideLine> guide_of(const PlanOptions& o, const std::string& crs_definition) {
  if (!o.ab.empty()) {
    const std::vector<double> n = four_numbers(o.ab);
    return guide_of_points({n[0], n[1]}, {n[2], n[3]}, "--ab", crs_definition);
  }
  if (o.guide_file.empty()) return std::nullopt;
  io::VectorQuery query;
  query.file = o.guide_file;
  query.where = o.guide_where;
  query.all_layers = true;
  return read_guide(io::read_guides(query), crs_definition);
}

Gates gates_of(const PlanOptions& o, const std::string& crs_definition) {
  return {gate_of(o.start, "--start", crs_definition), gate_of(o.end, "--end", crs_definition)};
}

void place_gates(const Gates& gates, const Field& field, PlanSettings& settings) {
  if (gates.start) settings.route.start = placed_gate(*gates.start, field);
  if (gates.end) settings.route.end = placed_gate(*gates.end, field);
}

namespace {

/// The border on the right of the swath along a line: tracks are numbered from borders.
std::vector<Point> border_beside(const std::vector<Point>& line, double width_m, const std::string& origin) {
  std::vector<Point> out = kinked_offset(line, 0.5 * width_m);
  if (out.size() < 2)
    throw bad_input(
        fmt::format("{}: the line bends so tightly that no swath of {} m lies along it", origin, width_m));
  return out;
}

}  // namespace

PlanSettings settings_for(const PlanSettings& settings, const std::optional<GuideLine>& guide,
                          const Field& field, const Machine& machine) {
  PlanSettings out = settings;
  if (!guide) return out;
  out.guide = placed_guide(*guide, field, machine.width_m);
  if (guide->role == GuideRole::kTrack && out.ab_anchor != AbAnchor::kEnvelope)
    out.guide = border_beside(out.guide, machine.width_m, guide->origin);
  out.shape = out.guide.size() > 2 ? TrackShape::kCurved : TrackShape::kStraight;
  return out;
}

Machine machine_of(const PlanOptions& o) {
  Machine machine = o.machine_file.empty() ? Machine{} : io::read_machine(o.machine_file);
  if (o.width_m) machine.width_m = *o.width_m;
  if (o.radius_m) machine.radius_m = *o.radius_m;
  // Zhou drops no piece.
  if (machine.min_length_m < 0 && o.tracks == name(TrackConstruction::kPaper)) machine.min_length_m = 0;
  if (o.min_length_m) machine.min_length_m = length_typed(*o.min_length_m, kLeastTrackLength);
  machine = with_rates_typed(o, std::move(machine));
  machine.turning = turning_typed(o.turning, machine.turning);
  return machine;
}

Objective objective_of(const PlanOptions& o) {
  constexpr Objective kFree{0, 0, 0, 0, 0};
  if (!o.minimise.empty()) return weights_of(scenario_named(o.minimise));
  if (!o.weights.empty()) return prices_typed(o.weights, "--weights", kFree);
  if (o.prices.empty()) return {};
  // Stops and subfields have no price in Versleijen's eq. 1.
  return prices_typed(o.prices, "--prices", o.like == "versleijen" ? kFree : Objective{});
}

Objective prices_typed(const std::string& text, const char* option, const Objective& otherwise) {
  const auto n = numbers_in(text, option);
  return {n[0], n[1], n[2], n.size() > 3 ? n[3] : otherwise.stop, n.size() > 4 ? n[4] : otherwise.subfield};
}

PlanSettings settings_of(const PlanOptions& o) {
  PlanSettings settings;
  settings.strategy = chosen(strategy_named(o.strategy), "--strategy", o.strategy, "best or sweep");
  settings.direction_tolerance = Angle::degrees(o.direction_tolerance_deg);
  settings.prove = o.prove;
  set_headlands(o, settings);
  settings.turns = turns_typed(o, settings);
  if (settings.turns == TurnPlanning::kRoute && !is_priced_otherwise(o)) settings.aim = Aim::kWholeCost;
  set_order(o, settings);
  settings.route.passes =
      chosen(pass_time_named(o.headland_time), "--headland-time", o.headland_time, "first or last");
  settings.route.sequence = chosen(pass_sequence_named(o.pass_sequence), "--pass-sequence", o.pass_sequence,
                                   "any, inwards or outwards");
  settings.route.corners =
      chosen(pass_corners_named(o.pass_corners), "--pass-corners", o.pass_corners, "auto or round");
  if (o.turn_room_m) settings.turn_room_m = length_typed(*o.turn_room_m, "room to turn beyond the boundary");
  settings.towing_error_m = length_typed(o.towing_error_m, "lateral error of a towed implement");
  settings.shape = shape_of(o.curved);
  settings.tracks = chosen(track_construction_named(o.tracks), "--tracks", o.tracks, "parallel or paper");
  if (!o.ab_anchor.empty())
    settings.ab_anchor = chosen(ab_anchor_named(o.ab_anchor), "--ab-anchor", o.ab_anchor, "line or envelope");
  if (!o.end_rule.empty())
    settings.end_rule =
        chosen(end_rule_named(o.end_rule), "--end-rule", o.end_rule, "cheapest, centre, cover or inside");
  else if (settings.tracks == TrackConstruction::kPaper)
    settings.end_rule = EndRule::kCover;
  settings.boundary = chosen(edge_kind_named(o.boundary), "--boundary", o.boundary, "soft or hard");
  settings.cell_direction = chosen(cell_direction_named(o.cell_direction), "--cell-direction",
                                   o.cell_direction, "rectangle or width");
  set_avoidance(o, settings);
  settings.merge_threshold = Angle::degrees(o.merge_deg);
  settings.decomposition_threshold = Angle::degrees(o.decomposition_deg);
  settings.short_edge_m = o.short_edge_m;
  return settings;
}

}  // namespace tramline::app
