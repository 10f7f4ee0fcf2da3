#include "report/repair_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "report/plan_report.h"
#include "report/plan_summary.h"
#include "tramline/geodesy/field_projection.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

/// Gaps of one kind that the table names; all are in the JSON.
constexpr std::size_t kListed = 5;

/// Where people find it: longitude and latitude, or the input's plane.
Point in_input(const LocalFrame& frame, Point p) {
  if (frame.geodetic) return FrameProjection(frame).to_lonlat(p);
  return p + Point{frame.origin_x_m, frame.origin_y_m};
}

ordered_json left_json(const std::vector<UnworkedGap>& left, const LocalFrame& frame) {
  ordered_json out = ordered_json::array();
  for (const UnworkedGap& gap : left) {
    const Point at = in_input(frame, gap.at);
    out.push_back({{"number", gap.number},
                   {"area_m2", gap.area_m2},
                   {"x_m", gap.at.x},
                   {"y_m", gap.at.y},
                   {"lon_deg", frame.geodetic ? ordered_json(at.x) : ordered_json()},
                   {"lat_deg", frame.geodetic ? ordered_json(at.y) : ordered_json()},
                   {"why", gap.why}});
  }
  return out;
}

double sum_m2(const std::vector<UnworkedGap>& left) {
  double sum = 0;
  for (const UnworkedGap& gap : left) sum += gap.area_m2;
  return sum;
}

std::string left_rows(const std::vector<UnworkedGap>& left, const LocalFrame& frame, bool with_reasons) {
  std::string out;
  for (std::size_t i = 0; i < std::min(kListed, left.size()); ++i) {
    const Point at = in_input(frame, left[i].at);
    out += fmt::format("  gap {:<6} {:.2f} m² at ({:.9g}, {:.9g}){}\n", left[i].number, left[i].area_m2, at.x,
                       at.y, with_reasons ? ": " + left[i].why : "");
  }
  if (left.size() > kListed) out += fmt::format("  and {} more\n", left.size() - kListed);
  return out;
}

}  // namespace

ordered_json repair_json(const RepairPlan& repair, double min_area_m2, double seconds) {
  const LocalFrame& frame = repair.plan.field.frame;
  ordered_json out = plan_json(repair.plan, {}, seconds);
  out.erase("seconds");
  out["min_area_m2"] = min_area_m2;
  out["gaps"] = repair.gaps;
  out["gaps_taken"] = repair.worked_gaps;
  out["gaps_ignored"] = left_json(repair.ignored, frame);
  out["gaps_unreachable"] = left_json(repair.unreachable, frame);
  out["gaps_not_worth"] = left_json(repair.not_worth, frame);
  out["missed_before_m2"] = repair.missed_before_m2;
  out["missed_after_m2"] = repair.missed_after_m2;
  out["cost_if_left"] = repair.cost_if_left;
  out["cost_of_passes"] = repair.cost_of_passes;
  out["cost_after"] = repair.cost_after;
  out["seconds"] = seconds;
  return out;
}

std::string repair_table(const RepairPlan& repair, double min_area_m2, double seconds) {
  const LocalFrame& frame = repair.plan.field.frame;
  std::string out =
      fmt::format("gaps         {}, {} worked; missed {:.1f} m² before, {:.1f} m² after\n", repair.gaps,
                  repair.worked_gaps, repair.missed_before_m2, repair.missed_after_m2);
  out += fmt::format(
      "prices       left as they are the gaps cost {:.2f}; the passes cost {:.2f} and leave {:.2f}: {:.2f} "
      "saved\n",
      repair.cost_if_left, repair.cost_of_passes, repair.cost_after - repair.cost_of_passes,
      repair.cost_if_left - repair.cost_after);
  if (!repair.not_worth.empty())
    out += fmt::format("not worth it {} gaps, {:.1f} m² in all\n", repair.not_worth.size(),
                       sum_m2(repair.not_worth)) +
           left_rows(repair.not_worth, frame, true);
  if (!repair.ignored.empty())
    out += fmt::format("ignored      {} gaps smaller than {:g} m², {:.1f} m² in all\n", repair.ignored.size(),
                       min_area_m2, sum_m2(repair.ignored)) +
           left_rows(repair.ignored, frame, false);
  if (!repair.unreachable.empty())
    out += fmt::format("unreachable  {} places, {:.1f} m² in all\n", repair.unreachable.size(),
                       sum_m2(repair.unreachable)) +
           left_rows(repair.unreachable, frame, true);
  return out + plan_summary(repair.plan, {}) + plan_details(repair.plan, {}, seconds);
}

}  // namespace tramline::app
