#include "report/watch_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/report_parts.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

std::string time_text(double seconds) {
  const auto minutes = static_cast<long long>(std::ceil(seconds / 60));
  if (minutes >= 6000) return "more than 100 h";
  return minutes < 60 ? fmt::format("{} min", minutes)
                      : fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

ordered_json section_json(const Section& place, const coverage::SectionAhead& section) {
  ordered_json out;
  out["left_m"] = place.left_m;
  out["right_m"] = place.right_m;
  out["on"] = section.on;
  out["need"] = section.need;
  out["over"] = name(section.over);
  out["next"] = nullptr;
  if (!section.next) return out;
  out["next"] = {{"on", section.next->on},
                 {"command_s", section.next->command_s},
                 {"effect_s", section.next->effect_s},
                 {"ahead_m", section.next->ahead_m},
                 {"over", name(section.next_over)}};
  return out;
}

ordered_json ahead_json(const std::optional<coverage::Ahead>& ahead) {
  if (!ahead) return nullptr;
  ordered_json out = ordered_json::array();
  for (std::size_t i = 0; i < ahead->sections.size(); ++i)
    out.push_back(section_json(ahead->boom[i], ahead->sections[i]));
  return out;
}

/// Commands this close together are one for the eye, s.
constexpr double kTogether_s = 0.25;

/// The next command: "sections 2-4 of 7 off in 1.3 s (worked)".
std::string ahead_text(const coverage::Ahead& ahead) {
  const auto& sections = ahead.sections;
  const auto sooner = [](const coverage::SectionAhead& a, const coverage::SectionAhead& b) {
    return a.next && (!b.next || a.next->command_s < b.next->command_s);
  };
  const auto first = std::min_element(sections.begin(), sections.end(), sooner);
  if (first == sections.end() || !first->next) return "nothing to switch";
  std::vector<std::size_t> together;
  for (std::size_t i = 0; i < sections.size(); ++i)
    if (const auto& next = sections[i].next;
        next && next->on == first->next->on && next->command_s < first->next->command_s + kTogether_s)
      together.push_back(i + 1);
  const std::string which =
      sections.size() == 1 ? "boom"
      : together.size() == 1
          ? fmt::format("section {} of {}", together.front(), sections.size())
          : fmt::format("{} of sections {}-{}", together.size(), together.front(), together.back());
  const double in_s = first->next->command_s;
  const std::string when = in_s < kTogether_s ? "now" : fmt::format("in {:.1f} s", in_s);
  return fmt::format("{} {} {} ({})", which, first->next->on ? "on" : "off", when, name(first->next_over));
}

}  // namespace

double present_ha_per_hour(const LiveFigures& live) { return live.present_m2_per_s * 3600 / 1e4; }

double remaining_s(const LiveFigures& live) {
  if (live.evaluation.coverage.field.empty() || !(live.present_m2_per_s > 0)) return std::nan("");
  return live.evaluation.coverage.areas.missed_m2 / live.present_m2_per_s;
}

ordered_json live_json(const LiveFigures& live) {
  ordered_json out = evaluation_json(live.evaluation);
  if (!live.final) {
    out["missed_regions"] = nullptr;
    if (out.contains("gaps")) out["gaps"] = nullptr;
  }
  out["final"] = live.final;
  out["settled"] = live.settled;
  out["time_s"] = number_json(live.time_s);
  out["working"] = live.working ? ordered_json(*live.working) : ordered_json();
  out["present_ha_per_hour"] = number_json(present_ha_per_hour(live));
  out["remaining_s"] = number_json(remaining_s(live));
  out["stalled_s"] = live.stalled_s ? number_json(*live.stalled_s) : ordered_json();
  if (live.looks_ahead) out["ahead"] = ahead_json(live.ahead);
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
  if (live.ahead) out += " | " + ahead_text(*live.ahead);
  if (live.stalled_s) out += fmt::format(" | NO FIX for {:.0f} s", *live.stalled_s);
  return out;
}

}  // namespace tramline::app
