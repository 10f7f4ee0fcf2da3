#include "report/front_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "report/report_parts.h"
#include "tramline/model/plain_zero.h"
#include "tramline/planner/pareto/front_marks.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

/// As programs know it: "least overlap" becomes "least_overlap".
std::vector<std::string> mark_keys(const Front& front, std::size_t point) {
  std::vector<std::string> out;
  for (const char* mark : marks_of(front, point)) {
    out.emplace_back(mark);
    std::replace(out.back().begin(), out.back().end(), ' ', '_');
  }
  return out;
}

std::vector<double> degrees_of(const FrontPoint& point) {
  std::vector<double> out;
  for (const Direction& direction : point.directions) out.push_back(plain_zero(direction.degrees()));
  return out;
}

struct Winner {
  std::size_t point;
  double cost;
};

Winner winner_for(const Front& front, const Objective& prices) {
  const std::size_t best = cheapest_for(front, prices);
  return {best, cost(prices, front.points[best].tally)};
}

/// Of the range of each number: plans nearer to one another are much alike.
constexpr double kShownApart = 0.08;

constexpr const char* kFrontRow = "{:>5}  {:>12}  {:>12}  {:>5}  {:>5}  {:>9}  {:>16}  {:>12}  {}";

std::string head_row() {
  return fmt::format(kFrontRow, "plan", "overlap", "uncovered", "turns", "stops", "subfields", "direction",
                     "cost", "");
}

std::string point_row(const Front& front, std::size_t index) {
  constexpr std::size_t kShown = 2;
  const FrontPoint& point = front.points[index];
  return fmt::format(kFrontRow, index + 1, fmt::format("{:.1f} m²", plain_zero(point.tally.overlap_m2)),
                     fmt::format("{:.1f} m²", plain_zero(point.tally.uncovered_m2)), point.tally.turns,
                     point.tally.stops, point.directions.size(), directions_text(point.directions, kShown),
                     fmt::format("{:.2f}", point.cost), fmt::join(marks_of(front, index), ", "));
}

/// The winners for the prices asked for, and what stands apart.
std::vector<std::size_t> points_shown(const Comparison& c) {
  std::vector<std::size_t> out = points_to_show(c.front, kShownApart);
  for (const Objective& prices : c.asked) out.push_back(winner_for(c.front, prices).point);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Ends with a line feed, not with blanks.
std::string line_of(std::string row) {
  row.erase(row.find_last_not_of(' ') + 1);
  return row + "\n";
}

}  // namespace

ordered_json front_json(const Front& front) {
  ordered_json out = ordered_json::array();
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const FrontPoint& point = front.points[i];
    out.push_back({{"point", i + 1},
                   {"overlap_m2", point.tally.overlap_m2},
                   {"uncovered_m2", point.tally.uncovered_m2},
                   {"turns", point.tally.turns},
                   {"stops", point.tally.stops},
                   {"tracks", point.tally.pieces},
                   {"track_length_m", point.tally.track_length_m},
                   {"subfields", point.directions.size()},
                   {"direction_deg", degrees_of(point)},
                   {"cost", point.cost},
                   {"laid_for", weights_json(point.laid_for)},
                   {"marks", mark_keys(front, i)}});
  }
  return out;
}

ordered_json compare_json(const Comparison& c, const std::vector<Skipped>& skipped) {
  ordered_json winners = ordered_json::array();
  for (const Objective& prices : c.asked) {
    const Winner winner = winner_for(c.front, prices);
    winners.push_back(
        {{"weights", weights_json(prices)}, {"point", winner.point + 1}, {"cost", winner.cost}});
  }
  return {{"field_id", c.field.id},
          {"area_m2", area_m2(c.field)},
          {"width_m", c.machine.width_m},
          {"radius_m", c.machine.radius_m},
          {"strategy", name(c.settings.strategy)},
          {"end_rule", name(c.settings.end_rule)},
          {"weights", weights_json(c.front.prices)},
          {"front", front_json(c.front)},
          {"winners", std::move(winners)},
          {"repairs", repairs_json(c.field.repairs)},
          {"skipped", skipped_json(skipped)},
          {"cut_short", c.cut_short},
          {"seconds", c.seconds}};
}

std::string compare_table(const Comparison& c, const std::vector<Skipped>& skipped) {
  std::string out = fmt::format(
      "field        {}, {:.4f} ha without the obstacles\nmachine      {}{:g} m wide, turning radius {:g} m\n",
      c.field.id, area_m2(c.field) / 1e4, c.machine.name.empty() ? "" : c.machine.name + ", ",
      c.machine.width_m, c.machine.radius_m);
  out += fmt::format("cost         {}\n", prices_text(c.front.prices));
  out += fmt::format("time         {:.3f} s\n", c.seconds);
  out += skipped_rows(skipped);
  out += fmt::format("front        {} plans, each better than any other in something\n\n",
                     c.front.points.size());
  if (c.cut_short)
    out += "note         the searches were stopped before their end: longer ones may find better plans\n\n";
  out += line_of(head_row());
  const std::vector<std::size_t> shown = points_shown(c);
  for (const std::size_t point : shown) out += line_of(point_row(c.front, point));
  if (const std::size_t more = c.front.points.size() - shown.size(); more > 0)
    out += fmt::format("\n{} more {} little from one of these; --json and --csv list all\n", more,
                       more == 1 ? "plan differs" : "plans differ");
  if (!c.asked.empty()) out += "\n";
  for (const Objective& prices : c.asked) {
    const Winner winner = winner_for(c.front, prices);
    out += fmt::format("plan {} costs least, {:.2f}, for {}\n", winner.point + 1, winner.cost,
                       prices_text(prices));
  }
  return out;
}

std::string front_csv(const Front& front) {
  std::string out = "point,overlap_m2,uncovered_m2,turns,stops,subfields,direction_deg,cost,marks\n";
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const FrontPoint& point = front.points[i];
    fmt::format_to(
        std::back_inserter(out), "{},{},{},{},{},{},{},{},{}\n", i + 1, plain_zero(point.tally.overlap_m2),
        plain_zero(point.tally.uncovered_m2), point.tally.turns, point.tally.stops, point.directions.size(),
        fmt::join(degrees_of(point), ";"), plain_zero(point.cost), fmt::join(mark_keys(front, i), ";"));
  }
  return out;
}

}  // namespace tramline::app
