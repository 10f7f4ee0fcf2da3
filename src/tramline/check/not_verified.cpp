#include "tramline/check/not_verified.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "tramline/check/rules/rules.h"
#include "tramline/check/turning/driven_machine.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"

namespace tramline::check {
namespace {

using Names = std::vector<std::string>;

/// Bounds are known to the search alone. A bound of 0 claims nothing.
void add_proof(const Plan& plan, Names& out) {
  if (plan.proof.bound != 0) out.emplace_back("proof.bound");
  if (plan.proof.one_direction_cost != 0) out.emplace_back("proof.one_direction_cost");
  if (plan.proof.one_direction_bound != 0) out.emplace_back("proof.one_direction_bound");
  out.emplace_back("proof.cut_short");
  out.emplace_back("directions_tried");
}

/// Prices of things that the plan does not contain have no effect on its cost.
void add_prices(const Plan& plan, Names& out) {
  if (plan.tally.overlap_m2 == 0) out.emplace_back("objective.overlap");
  if (plan.tally.uncovered_m2 == 0) out.emplace_back("objective.uncovered");
  if (plan.tally.turns == 0) out.emplace_back("objective.turn");
  if (plan.tally.stops == 0) out.emplace_back("objective.stop");
  if (further_subfields(plan.tally) == 0) out.emplace_back("objective.subfield");
}

/// Settings that only determine how the plan was searched for, and requirements that a plan may exceed.
void add_settings(const Plan& plan, Names& out) {
  for (const char* key :
       {"machine.radius_m", "machine.min_length_m", "settings.strategy", "settings.end_rule",
        "settings.boundary", "settings.cell_direction", "settings.direction_tolerance",
        "settings.merge_threshold", "settings.decomposition_threshold", "settings.short_edge_m",
        "settings.small_cell_m2", "settings.avoid", "settings.avoid_threshold_m", "settings.avoid_room_m",
        "settings.clearance_m", "settings.shape", "settings.tracks", "settings.guide", "settings.ab_anchor"})
    out.emplace_back(key);
  const auto& passes = plan.headland.obstacle_passes;
  const bool by_turns = plan.settings.obstacle_headland_rule == HeadlandRule::kTurns;
  if (by_turns || std::none_of(passes.begin(), passes.end(), [](int n) { return n > 0; }))
    out.emplace_back("settings.obstacle_headlands");
  if (plan.headland.passes.empty()) out.emplace_back("headland.construction");
  if (!references(plan).empty()) out.emplace_back(common_reference(plan) ? "reference" : "references");
}

/// Tracks and headland passes are judged by width and radius alone.
void add_turning(const Plan& plan, Names& out) {
  const Turning& turning = plan.machine.turning;
  if (turning == Turning{}) return;
  for (const char* key : {kReverseKey, kImplementKey}) out.push_back(fmt::format("machine.{}", key));
  for (const TurningNumber& number : kTurningNumbers) out.push_back(fmt::format("machine.{}", number.key));
}

/// Prices price a plan, whatever it is; that no other plan costs less is not verified.
void add_rates(const Plan& plan, Names& out) {
  if (plan.settings.aim != Aim::kCost) out.emplace_back("settings.aim");
  const Rates& rates = plan.machine.rates;
  if (rates == Rates{}) return;
  out.push_back(fmt::format("machine.{}", kOperationKey));
  for (const RateNumber& number : kRateNumbers)
    if (rates.*number.value >= 0) out.push_back(fmt::format("machine.{}", number.key));
}

bool is_rate(const std::string& name) {
  constexpr std::string_view kMachine = "machine.";
  if (!name.starts_with(kMachine)) return false;
  const std::string_view key = std::string_view(name).substr(kMachine.size());
  return key == kOperationKey || std::any_of(kRateNumbers.begin(), kRateNumbers.end(),
                                             [&](const RateNumber& number) { return key == number.key; });
}

void add_encounters(const Plan& plan, Names& out) {
  if (plan.encounters.empty()) return;
  for (const char* column : {"encounters.cost_left", "encounters.cost_right", "encounters.why_not_left",
                             "encounters.why_not_right"})
    out.emplace_back(column);
}

/// The tracks of other plans are not in the file: their figures only have to agree with one another.
void add_front(const Plan& plan, Names& out) {
  if (plan.front.points.empty()) return;
  for (const char* column : {"front.overlap_m2", "front.uncovered_m2", "front.turns", "front.stops",
                             "front.crossings", "front.tracks", "front.track_length_m", "front.direction_rad",
                             "front.knee", "front.laid_for", "front.worked_subfields"})
    out.emplace_back(column);
}

void add_swaths(const Plan& plan, Names& out) {
  if (std::any_of(plan.pieces.begin(), plan.pieces.end(),
                  [](const TrackPiece& piece) { return !piece.overlap_m2.has_value(); }))
    out.emplace_back("swaths.overlap_m2");
}

/// The bound of a route is proven with any prices; a lower one proves less.
void add_route(const Plan& plan, Names& out) {
  if (!plan.route.planned()) return;
  out.emplace_back("settings.route.order");
  const Turning& turning = plan.machine.turning;
  if (!tows(turning)) out.emplace_back("route_legs.lateral_error_m");
}

constexpr const char* kRepairs = "field.repairs";
constexpr const char* kFieldWarnings = "field.warnings";
constexpr const char* kFrame = "frame";

}  // namespace

std::vector<std::string> not_verified(const Plan& plan) {
  Names out;
  if (is_of_lines(plan)) out.emplace_back("origin");
  add_proof(plan, out);
  add_encounters(plan, out);
  add_front(plan, out);
  add_swaths(plan, out);
  add_route(plan, out);
  if (!plan.given_up.empty()) out.emplace_back("given_up");
  if (!plan.worked.empty() && !is_repair(plan)) out.emplace_back("worked");
  if (std::any_of(plan.subfields.begin(), plan.subfields.end(),
                  [](const Subfield& subfield) { return !subfield.given_by.empty(); }))
    out.emplace_back("subfields.given_by");
  if (!plan.dropped.empty()) out.emplace_back("dropped");
  for (const char* key : {kRepairs, kFieldWarnings, kFrame}) out.emplace_back(key);
  if (plan.figures == PlanFigures::kTracks) out.emplace_back("warnings");
  add_prices(plan, out);
  add_settings(plan, out);
  add_rates(plan, out);
  add_turning(plan, out);
  return out;
}

std::vector<std::string> without_field(std::vector<std::string> names) {
  std::erase_if(names, [](const std::string& name) {
    return name == kRepairs || name == kFieldWarnings || name == kFrame;
  });
  return names;
}

std::vector<std::string> without_rates(std::vector<std::string> names) {
  std::erase_if(names, is_rate);
  return names;
}

}  // namespace tramline::check
