#include <fmt/format.h>

#include <algorithm>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/edge_runs.h"
#include "tramline/check/measure/self_crossing.h"
#include "tramline/check/measure/sound_path.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

void check_depth(const Plan& plan, int passes, const char* round_what, Violations& out) {
  if (passes >= 0 && passes * plan.machine.width_m <= kFarthest_m) return;
  out.push_back({Rule::kHeadland,
                 fmt::format("{} passes round {} are asked for", passes, round_what),
                 {},
                 static_cast<double>(passes)});
}

void check_obstacle_passes(const Plan& plan, Violations& out) {
  const auto& passes = plan.headland.obstacle_passes;
  const auto& obstacles = plan.field.obstacles;
  if (passes.size() > obstacles.size())
    out.push_back(
        {Rule::kHeadland,
         fmt::format("{} obstacles have headlands, and there are {}", passes.size(), obstacles.size()),
         {},
         static_cast<double>(passes.size())});
  for (std::size_t i = 0; i < std::min(passes.size(), obstacles.size()); ++i) {
    const bool may_have = obstacles[i].kind == ObstacleKind::kObstacle;
    const int most = may_have ? plan.settings.obstacle_headlands : 0;
    // A boundary has all the passes that were asked for, or tracks go round it and it has none. Where turns
    // decide, it may have any number.
    if (passes[i] == 0 || passes[i] == most) continue;
    const bool any_number = may_have && plan.settings.obstacle_headland_rule == HeadlandRule::kTurns;
    if (any_number && passes[i] > 0 && passes[i] * plan.machine.width_m <= kFarthest_m) continue;
    out.push_back(
        {Rule::kHeadland,
         fmt::format("obstacle {} has {} headland passes, and {} were asked for", i + 1, passes[i], most),
         obstacles[i].shape.outer.front(), static_cast<double>(passes[i])});
  }
}

/// The fault of the numbers of passes by edge, or "".
std::string fault_of_edge_passes(const Plan& plan) {
  const std::vector<int>& passes = plan.headland.edge_passes;
  if (passes != plan.settings.headland_edges)
    return "the edges of the field do not have the headland passes that were asked for";
  if (passes.empty()) return "";
  if (passes.size() != plan.field.outer.size())
    return fmt::format("{} edges have numbers of headland passes, and the field has {}", passes.size(),
                       plan.field.outer.size());
  if (passes_everywhere(passes) < 0) return "an edge has fewer headland passes than none";
  if (passes_anywhere(passes) == plan.settings.headlands) return "";
  return fmt::format("no edge has more than {} headland passes, and {} were asked for",
                     passes_anywhere(passes), plan.settings.headlands);
}

/// The largest number of passes among the boundaries that the pass names.
int most_passes(const Plan& plan, const HeadlandPass& pass) {
  int out = pass.around_field ? plan.settings.headlands : 0;
  for (const std::size_t i : pass.obstacles) out = std::max(out, passes_round(plan, i));
  return out;
}

/// The fault of a pass in itself, or "".
std::string fault_of(const Plan& plan, const HeadlandPass& pass) {
  if (std::string fault = check::fault_of(pass.path); !fault.empty()) return fault;
  if (plan.headland.construction == HeadlandConstruction::kPlain &&
      !(is_closed(pass) && is_kinked(pass.path)))
    return "is no ring with corners, as those of a plain headland are";
  if (!exist(plan, pass.obstacles)) return "names an obstacle that does not exist";
  if (!std::is_sorted(pass.obstacles.begin(), pass.obstacles.end(), std::less_equal<>()))
    return "does not name its obstacles in order";
  if (is_of_lines(plan)) return "";  // they may be any number of passes, round anything
  if (pass.number < 1 || pass.number > most_passes(plan, pass))
    return fmt::format("is number {} round what has {}", pass.number, most_passes(plan, pass));
  return "";
}

}  // namespace

void check_headland(const Plan& plan, Violations& out) {
  check_depth(plan, plan.settings.headlands, "the field", out);
  check_depth(plan, plan.settings.obstacle_headlands, "obstacles", out);
  const Point somewhere = plan.field.outer.empty() ? Point{} : plan.field.outer.front();
  if (const std::string fault = fault_of_edge_passes(plan); !fault.empty())
    out.push_back({Rule::kHeadland, fault, somewhere, 1});
  check_obstacle_passes(plan, out);
  const auto& passes = plan.headland.passes;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (const std::string fault = fault_of(plan, passes[i]); !fault.empty()) {
      const Point at = passes[i].path.empty() ? Point{} : passes[i].path.front().from;
      out.push_back({Rule::kHeadland, pass_name(i) + " " + fault, at, 0});
    } else if (is_of_lines(plan)) {
      continue;  // they may cross themselves: each square metre counts once
    } else if (const auto point = self_crossing_of(passes[i].path)) {
      out.push_back({Rule::kHeadland, pass_name(i) + " crosses itself", *point, 0});
    }
  }
}

}  // namespace tramline::check
