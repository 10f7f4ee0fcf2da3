#include "report/price_report.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "report/plan_report.h"
#include "report/plan_summary.h"
#include "report/report_parts.h"
#include "tramline/model/plain_zero.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

struct Figure {
  const char* key;
  const char* what;
  int digits;
  double given, planned;
};

/// Those that both plans have, in the order of the tables of Versleijen 2019.
std::vector<Figure> figures_of(const Plan& given, const Plan& planned) {
  const Tally &a = given.tally, &b = planned.tally;
  return {
      {"overlap_m2", "overlap, m²", 1, a.overlap_m2, b.overlap_m2},
      {"uncovered_m2", "uncovered, m²", 1, a.uncovered_m2, b.uncovered_m2},
      {"turns", "turns", 0, a.turns + 0.0, b.turns + 0.0},
      {"stops", "stops", 0, a.stops + 0.0, b.stops + 0.0},
      {"crossings", "crossings", 0, a.crossings + 0.0, b.crossings + 0.0},
      {"tracks", "tracks", 0, a.pieces + 0.0, b.pieces + 0.0},
      {"track_length_m", "track length, m", 1, a.track_length_m, b.track_length_m},
      {"headland_length_m", "headland passes, m", 1, length(given.headland), length(planned.headland)},
      {"worked_m2", "worked, m²", 1, a.worked_m2, b.worked_m2},
      {"further_subfields", "further subfields", 0, further_subfields(a) + 0.0, further_subfields(b) + 0.0},
      {"cost", "cost", 2, given.cost, planned.cost}};
}

ordered_json difference_json(const Plan& given, const Plan& planned) {
  ordered_json out = ordered_json::object();
  for (const Figure& figure : figures_of(given, planned)) {
    const double difference = figure.planned - figure.given;
    out[figure.key] = figure.digits == 0 ? ordered_json(std::lround(difference)) : ordered_json(difference);
    out[fmt::format("{}_pct", figure.key)] =
        figure.given != 0 ? ordered_json(100 * difference / figure.given) : ordered_json();
  }
  return out;
}

/// Rules of planning do not apply to lines.
ordered_json lines_json(const Plan& plan, const std::vector<Skipped>& skipped, double seconds) {
  ordered_json out = plan_json(plan, skipped, seconds);
  for (const char* key : {"strategy", "end_rule", "boundary", "directions_tried", "bound", "gap",
                          "one_direction_cost", "gap_one_direction"})
    out[key] = nullptr;
  return out;
}

std::string given_rows(const PricedPlans& plans) {
  return figure_rows(plans.given) +
         fmt::format("cost         {:.2f} = {}\n", plans.given.cost, prices_text(plans.given.objective)) +
         note_rows(plans.given.warnings) + skipped_rows(plans.skipped);
}

std::string rounded(double value, int digits) {
  const double step = std::pow(10, digits);
  return fmt::format("{:.{}f}", plain_zero(std::round(value * step) / step), digits);
}

std::string comparison_rows(const Plan& given, const Plan& planned) {
  std::string out =
      fmt::format("{:<20}{:>14}{:>14}{:>14}{:>10}\n", "", "given", "planned", "difference", "%");
  for (const Figure& figure : figures_of(given, planned)) {
    if (figure.given == 0 && figure.planned == 0) continue;
    const double difference = figure.planned - figure.given;
    const std::string share =
        figure.given != 0 ? fmt::format("{:+.2f}", 100 * difference / figure.given) : std::string("-");
    // Superscripts are two bytes wide and one column.
    const std::string what = figure.what;
    const std::size_t wide = what.find("²") == std::string::npos ? 20 : 21;
    fmt::format_to(std::back_inserter(out), "{:<{}}{:>14}{:>14}{:>14}{:>10}\n", what, wide,
                   rounded(figure.given, figure.digits), rounded(figure.planned, figure.digits),
                   rounded(difference, figure.digits), share);
  }
  return out;
}

}  // namespace

ordered_json price_json(const PricedPlans& plans) {
  ordered_json given = lines_json(plans.given, plans.skipped, plans.seconds);
  if (plans.planned == nullptr) return given;
  ordered_json out;
  out["given"] = std::move(given);
  out["planned"] = plan_json(*plans.planned, {}, plans.seconds);
  for (const char* part : {"given", "planned"}) {
    out[part].erase("seconds");
    out[part].erase("field_id");
  }
  out["difference"] = difference_json(plans.given, *plans.planned);
  out["seconds"] = plans.seconds;
  return out;
}

std::string price_table(const PricedPlans& plans) {
  std::string out = given_rows(plans);
  if (plans.planned != nullptr) out += "\n" + comparison_rows(plans.given, *plans.planned);
  return out;
}

}  // namespace tramline::app
