#include "report/obstacle_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <vector>

#include "tramline/model/detour_summary.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

struct Reason {
  std::string text;
  int count = 0;
};

// The commonest first.
std::vector<Reason> reasons_for_cuts(const Plan& plan) {
  std::map<std::string, int> counts;
  for (const Encounter& encounter : plan.encounters)
    if (encounter.chosen == Passing::kCut) ++counts[reason_for_cut(encounter, plan.settings.avoid)];
  std::vector<Reason> out;
  for (const auto& [text, count] : counts) out.push_back({text, count});
  std::stable_sort(out.begin(), out.end(),
                   [](const Reason& a, const Reason& b) { return a.count > b.count; });
  return out;
}

std::string cut_row(const Plan& plan) {
  std::string list;
  int cuts = 0;
  for (const Reason& reason : reasons_for_cuts(plan)) {
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", reason.text, reason.count);
    cuts += reason.count;
  }
  if (cuts == 0) return "";
  return fmt::format("cut          {} of {} encounters with obstacles: {}\n", cuts, plan.encounters.size(),
                     list);
}

ordered_json cost_or_null(const WayPast& way) {
  return way.possible ? ordered_json(way.cost) : ordered_json();
}

ordered_json why_not_or_null(const WayPast& way) {
  return way.possible ? ordered_json() : ordered_json(way.why_not);
}

ordered_json encounter_json(const Encounter& encounter) {
  ordered_json obstacles = ordered_json::array();
  for (const std::size_t index : encounter.obstacles) obstacles.push_back(index + 1);
  return {{"subfield", encounter.subfield + 1},
          {"track", encounter.track + 1},
          {"x_m", encounter.at.x},
          {"y_m", encounter.at.y},
          {"obstacles", std::move(obstacles)},
          {"chosen", name(encounter.chosen)},
          {"cost_left", cost_or_null(encounter.left)},
          {"cost_right", cost_or_null(encounter.right)},
          {"why_not_left", why_not_or_null(encounter.left)},
          {"why_not_right", why_not_or_null(encounter.right)}};
}

}  // namespace

std::string reason_for_cut(const Encounter& encounter, Avoidance avoid) {
  assert(encounter.chosen == Passing::kCut);
  if (avoid == Avoidance::kCut) return "as --avoid cut asks";
  const WayPast& left = encounter.left;
  const WayPast& right = encounter.right;
  if (left.possible || right.possible) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const double cheapest = std::min(left.possible ? left.cost : kNone, right.possible ? right.cost : kNone);
    return cheapest >= 0 ? "cutting costs less" : fmt::format("as --avoid {} asks", name(avoid));
  }
  // In one order, so that mirror images are counted together.
  const auto& [first, second] = std::minmax(left.why_not, right.why_not);
  if (second.empty()) return "no way round";
  return first.empty() || first == second ? second : first + " / " + second;
}

std::string obstacle_rows(const Plan& plan) {
  const DetourSummary detours = summary_of_detours(plan);
  if (detours.count() == 0 && plan.encounters.empty()) return "";
  std::string out = "detours      0\n";
  if (detours.count() > 0)
    out = fmt::format("detours      {} ({} left, {} right), smallest radius {:.2f} m\n", detours.count(),
                      detours.left, detours.right, detours.smallest_radius_m);
  return out + cut_row(plan);
}

void add_obstacle_keys(ordered_json& out, const Plan& plan) {
  const PlanSettings& settings = plan.settings;
  const DetourSummary detours = summary_of_detours(plan);
  out["avoid"] = name(settings.avoid);
  out["avoid_threshold_m"] =
      settings.avoid_threshold_m < 0 ? plan.machine.width_m : settings.avoid_threshold_m;
  out["avoid_room_m"] = settings.avoid_room_m < 0 ? ordered_json() : ordered_json(settings.avoid_room_m);
  out["clearance_m"] = settings.clearance_m;
  out["detours"] = detours.count();
  out["smallest_radius_m"] = detours.count() > 0 ? ordered_json(detours.smallest_radius_m) : ordered_json();
  out["encounters"] = ordered_json::array();
  for (const Encounter& encounter : plan.encounters) out["encounters"].push_back(encounter_json(encounter));
}

}  // namespace tramline::app
