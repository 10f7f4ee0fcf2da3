#include "report/turning/turns_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/report_parts.h"
#include "tramline/model/plain_zero.h"
#include "tramline/turns/tolerances.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

bool is_adjacent(const TurnsReport& report, double spacing_m) {
  return std::abs(spacing_m - report.machine.width_m) <= kSameDepth;
}

/// "Adjacent tracks" or "Jumps of 12 m".
std::string spacing_text(const TurnsReport& report, double spacing_m) {
  return is_adjacent(report, spacing_m) ? "Adjacent tracks" : fmt::format("Jumps of {:g} m", spacing_m);
}

ordered_json turn_row_json(const TurnRow& row) {
  ordered_json out{
      {"kind", name(row.manoeuvre.kind)}, {"word", row.manoeuvre.word}, {"depth_m", row.depth_m},
      {"axle_depth_m", row.axle_depth_m}, {"back_m", row.back_m},       {"passes", row.passes},
      {"length_m", row.length_m},         {"time_s", row.time_s},       {"gear_changes", row.gear_changes}};
  if (row.run_in_m) out["run_in_m"] = number_json(*row.run_in_m);
  return out;
}

std::vector<double> spacings_in(const std::vector<TurnRow>& rows) {
  std::vector<double> out;
  for (const TurnRow& row : quickest_of_each(rows)) out.push_back(row.spacing_m);
  return out;
}

ordered_json spacings_json(const TurnsReport& report) {
  ordered_json out = ordered_json::array();
  for (const double spacing_m : spacings_in(report.rows)) {
    const std::vector<TurnRow> rows = rows_of(report.rows, spacing_m);
    ordered_json manoeuvres = ordered_json::array();
    for (const TurnRow& row : rows) manoeuvres.push_back(turn_row_json(row));
    out.push_back({{"spacing_m", spacing_m},
                   {"quickest", quickest(rows)},
                   {"shallowest", shallowest(rows)},
                   {"manoeuvres", std::move(manoeuvres)}});
  }
  return out;
}

std::string border_text(const TurnsReport& report) {
  const double degrees = report.settings.border.degrees();
  return degrees == 90 ? "square to the tracks" : fmt::format("at {:g}° to the tracks", degrees);
}

std::string machine_rows(const TurnsReport& report) {
  const Machine& machine = report.machine;
  const Turning& turning = machine.turning;
  std::string out = fmt::format("machine      {}{:g} m wide, turning radius {:g} m{}\n",
                                machine.name.empty() ? "" : machine.name + ", ", machine.width_m,
                                machine.radius_m, turning.reverse ? ", may reverse" : "");
  if (turning.implement == Coupling::kTowed)
    out += fmt::format("implement    towed on a drawbar of {:g} m: it is not reversed\n", turning.drawbar_m);
  out += fmt::format("border       {}\n", border_text(report));
  return out;
}

/// Where depths differ by less than this there is no more to say of the shallower, m.
constexpr double kShallower_m = 0.05;

std::string shallower_sentence(const TurnsReport& report, const TurnRow& quick) {
  const std::vector<TurnRow> rows = rows_of(report.rows, quick.spacing_m);
  const TurnRow& shallow = rows[shallowest(rows)];
  if (shallow.depth_m > quick.depth_m - kShallower_m) return "";
  return fmt::format(
      "The shallowest turn between them ({}) needs {:.1f} m: {}; it takes {:.1f} s, not {:.1f} s.",
      kind_text(shallow.manoeuvre.kind), shallow.depth_m, passes_text(shallow.passes), shallow.time_s,
      quick.time_s);
}

std::string need_sentence(const TurnsReport& report, const TurnRow& row) {
  return fmt::format("{} need {:.1f} m: {}.", spacing_text(report, row.spacing_m), row.depth_m,
                     passes_text(row.passes));
}

}  // namespace

std::string kind_text(ManoeuvreKind kind) {
  std::string out = name(kind);
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

std::string passes_text(int passes) { return fmt::format("{} {}", passes, passes == 1 ? "pass" : "passes"); }

std::vector<std::string> turns_summary(const TurnsReport& report) {
  const std::vector<TurnRow> best = quickest_of_each(report.rows);
  if (best.empty()) return {"The machine has no turn between these tracks."};
  const TurnRow& first = best.front();
  std::vector<std::string> out{need_sentence(report, first)};
  if (const std::string more = shallower_sentence(report, first); !more.empty()) out.push_back(more);
  const TurnRow& shallow = best[shallowest(best)];
  if (shallow.passes < first.passes) out.push_back(need_sentence(report, shallow));
  if (best.size() > 1) {
    const TurnRow& quick = best[quickest(best)];
    out.push_back(fmt::format("The quickest turn is over {:g} m ({}): {:.1f} s.", quick.spacing_m,
                              kind_text(quick.manoeuvre.kind), quick.time_s));
  }
  return out;
}

ordered_json turns_json(const TurnsReport& report) {
  const Machine& machine = report.machine;
  ordered_json out{{"machine", machine.name}, {"width_m", machine.width_m}, {"radius_m", machine.radius_m}};
  if (machine.turning != Turning{}) out["turning"] = turning_json(machine.turning);
  out["border_deg"] = report.settings.border.degrees();
  out["spacings"] = spacings_json(report);
  const std::vector<TurnRow> best = quickest_of_each(report.rows);
  out["quickest_spacing_m"] = best.empty() ? ordered_json() : ordered_json(best[quickest(best)].spacing_m);
  out["shallowest_spacing_m"] =
      best.empty() ? ordered_json() : ordered_json(best[shallowest(best)].spacing_m);
  out["summary"] = turns_summary(report);
  return out;
}

std::string turns_table(const TurnsReport& report, ShownTurns shown) {
  const bool all = shown == ShownTurns::kAll;
  const std::vector<TurnRow> rows = all ? report.rows : quickest_of_each(report.rows);
  const bool tows = !rows.empty() && rows.front().run_in_m.has_value();
  std::string out = machine_rows(report);
  out += fmt::format("\n{:>9}  {:<12}  {:>8}  {:>8}{}  {:>6}  {:>8}  {:>7}  {:>5}{}\n", "spacing", "turn",
                     "depth", "axle", all ? "      back" : "", "passes", "length", "time", "gears",
                     tows ? "    run-in" : "");
  for (const TurnRow& row : rows) {
    const std::string back = all ? fmt::format("  {:>6.2f} m", plain_zero(row.back_m)) : "";
    out +=
        fmt::format("{:>7g} m  {:<12}  {:>6.2f} m  {:>6.2f} m{}  {:>6}  {:>6.2f} m  {:>5.1f} s  {:>5}",
                    row.spacing_m, kind_text(row.manoeuvre.kind), row.depth_m, plain_zero(row.axle_depth_m),
                    back, row.passes, row.length_m, row.time_s, row.gear_changes);
    if (row.run_in_m)
      out += std::isfinite(*row.run_in_m) ? fmt::format("  {:>6.2f} m", *row.run_in_m) : "     never";
    out += '\n';
  }
  out += '\n';
  for (const std::string& sentence : turns_summary(report)) out += sentence + '\n';
  return out;
}

std::string turns_csv(const TurnsReport& report) {
  std::string out = "spacing_m,kind,word,depth_m,axle_depth_m,back_m,passes,length_m,time_s,gear_changes\n";
  for (const TurnRow& row : report.rows)
    out += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", row.spacing_m, name(row.manoeuvre.kind),
                       row.manoeuvre.word, row.depth_m, row.axle_depth_m, row.back_m, row.passes,
                       row.length_m, row.time_s, row.gear_changes);
  return out;
}

}  // namespace tramline::app
