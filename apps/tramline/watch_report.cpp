#include "watch_report.h"

#include <fmt/format.h>

#include <cmath>

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(); }

/// Time for what is missed at the present rate, s; NaN: not known.
double remaining_s(const LiveFigures& live) {
  if (live.evaluation.coverage.field.empty() || !(live.present_m2_per_s > 0)) return std::nan("");
  return live.evaluation.coverage.areas.missed_m2 / live.present_m2_per_s;
}

double present_ha_per_hour(const LiveFigures& live) { return live.present_m2_per_s * 3600 / 1e4; }

std::string time_text(double seconds) {
  const auto minutes = static_cast<long long>(std::ceil(seconds / 60));
  if (minutes >= 6000) return "more than 100 h";
  return minutes < 60 ? fmt::format("{} min", minutes)
                      : fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace

ordered_json live_json(const LiveFigures& live) {
  ordered_json out = evaluation_json(live.evaluation);
  if (!live.final) {
    out["missed_regions"] = nullptr;
    if (out.contains("gaps")) out["gaps"] = nullptr;
  }
  out["final"] = live.final;
  out["settled"] = live.settled;
  out["time_s"] = number(live.time_s);
  out["working"] = live.working ? ordered_json(*live.working) : ordered_json();
  out["present_ha_per_hour"] = number(present_ha_per_hour(live));
  out["remaining_s"] = number(remaining_s(live));
  out["stalled_s"] = live.stalled_s ? number(*live.stalled_s) : ordered_json();
  return out;
}

std::string status_line(const LiveFigures& live) {
  const Coverage& coverage = live.evaluation.coverage;
  const CoverageAreas& areas = coverage.areas;
  if (coverage.fixes_used == 0)
    return live.stalled_s ? fmt::format("no position yet, for {:.0f} s", *live.stalled_s) : "no position yet";
  std::string out =
      fmt::format("{:.2f} ha done, {:.2f} doubled", areas.covered_m2 / 1e4, areas.repeated_m2 / 1e4);
  if (!coverage.field.empty()) out += fmt::format(", {:.2f} missed", areas.missed_m2 / 1e4);
  if (std::isfinite(live.present_m2_per_s)) out += fmt::format(", {:.1f} ha/h", present_ha_per_hour(live));
  if (std::isfinite(remaining_s(live))) out += ", " + time_text(remaining_s(live)) + " left";
  if (live.working) out += *live.working ? " | work on" : " | work off";
  if (live.work_key) out += " (space)";
  if (live.stalled_s) out += fmt::format(" | NO FIX for {:.0f} s", *live.stalled_s);
  return out;
}

}  // namespace tramline::app
