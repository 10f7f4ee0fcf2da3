#include "report/explain_report.h"

#include <fmt/format.h>

#include <cmath>

#include "report/report_parts.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

bool is_counted(Cause cause) {
  return cause == Cause::kTurns || cause == Cause::kStops || cause == Cause::kSubfields;
}

ordered_json cause_json(Cause cause, const CausePart& part) {
  return {{"cause", name(cause)},
          {"overlap_m2", part.overlap_m2},
          {"uncovered_m2", part.uncovered_m2},
          {"count", is_counted(cause) ? ordered_json(part.count) : ordered_json()},
          {"cost", part.cost}};
}

ordered_json runner_up_json(const RunnerUp& plan) {
  ordered_json directions = ordered_json::array();
  for (const Direction direction : plan.directions) directions.push_back(direction.degrees());
  return {{"direction_deg", std::move(directions)},
          {"subfields", plan.directions.size()},
          {"overlap_m2", plan.tally.overlap_m2},
          {"uncovered_m2", plan.tally.uncovered_m2},
          {"turns", plan.tally.turns},
          {"stops", plan.tally.stops},
          {"cost", plan.cost},
          {"more", plan.more.sum()},
          {"more_by",
           {{"overlap", plan.more.overlap},
            {"uncovered", plan.more.uncovered},
            {"turns", plan.more.turns},
            {"stops", plan.more.stops},
            {"subfields", plan.more.subfields}}},
          {"main_reason", main_reason(plan.more)}};
}

/// 0 for what rounds to it: a table would show "-0.0".
double shown(double value, double smallest) { return std::abs(value) < smallest ? 0 : value; }

std::string area_text(double area_m2) { return fmt::format("{:.1f} m²", shown(area_m2, 0.05)); }

std::string difference_text(double cost) { return fmt::format("{:+.2f}", shown(cost, 0.005)); }

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

std::string cause_row(Cause cause, const CausePart& part, double cost) {
  return fmt::format("  {:<14}{:>14}{:>14}{:>8}{:>12.2f}{:>8.1f} %\n", name(cause),
                     area_text(part.overlap_m2), area_text(part.uncovered_m2),
                     is_counted(cause) ? fmt::format("{}", part.count) : "", part.cost,
                     percent(part.cost, cost));
}

bool is_worth_a_row(const CausePart& part) {
  constexpr double kShown_m2 = 0.05;
  return std::abs(part.overlap_m2) >= kShown_m2 || std::abs(part.uncovered_m2) >= kShown_m2 || part.count > 0;
}

std::string runner_up_row(std::size_t place, const RunnerUp& plan, double cost) {
  constexpr std::size_t kShown = 4;
  const CostDifference& more = plan.more;
  return fmt::format("  {:<14}{:>12.2f}{:>12}{:>8.1f} %  {:<10}{:>10}{:>11}{:>10}{:>10}  {} ({})\n", place,
                     plan.cost, difference_text(more.sum()), shown(percent(more.sum(), cost), 0.05),
                     main_reason(more), difference_text(more.overlap), difference_text(more.uncovered),
                     difference_text(more.turns), difference_text(more.stops), plan.directions.size(),
                     directions_text(plan.directions, kShown));
}

std::string runner_up_rows(const Explanation& why, double cost) {
  if (why.runner_ups.empty()) return "runner-ups   none differs by a degree or in its number of subfields\n";
  std::string out = fmt::format("{:<16}{:>12}{:>12}{:>10}  {:<10}{:>10}{:>11}{:>10}{:>10}  {}\n",
                                "runner-ups", "cost", "more", "", "mainly for", "overlap", "uncovered",
                                "turns", "stops", "subfields (direction)");
  for (std::size_t i = 0; i < why.runner_ups.size(); ++i)
    out += runner_up_row(i + 1, why.runner_ups[i], cost);
  return out;
}

/// What most people would have driven.
std::string longest_side_row(const RunnerUp& plan) {
  constexpr double kNothing = 0.005;
  const double more = plan.more.sum();
  if (plan.tally.pieces == 0)
    return fmt::format("longest side  at {:.2f}° no track fits\n", plan.directions.front().degrees());
  const std::string difference = std::abs(more) < kNothing ? "the same"
                                 : more > 0                ? fmt::format("{:.2f} more", more)
                                                           : fmt::format("{:.2f} less", -more);
  return fmt::format(
      "longest side  all tracks along it, at {:.2f}°, would cost {:.2f}, {}: overlap {}, uncovered {}, "
      "{} turns, {} stops\n",
      plan.directions.front().degrees(), plan.cost, difference, area_text(plan.tally.overlap_m2),
      area_text(plan.tally.uncovered_m2), plan.tally.turns, plan.tally.stops);
}

}  // namespace

ordered_json explain_json(const Explanation& why) {
  ordered_json causes = ordered_json::array(), runner_ups = ordered_json::array();
  for (std::size_t i = 0; i < kCauseCount; ++i)
    causes.push_back(cause_json(static_cast<Cause>(i), why.causes.parts[i]));
  for (const RunnerUp& plan : why.runner_ups) runner_ups.push_back(runner_up_json(plan));
  return {{"causes", std::move(causes)},
          {"runner_ups", std::move(runner_ups)},
          {"longest_side", runner_up_json(why.longest_side)}};
}

std::string explain_rows(const Explanation& why, double cost) {
  std::string out = fmt::format("{:<16}{:>14}{:>14}{:>8}{:>12}{:>10}\n", "cost by cause", "overlap",
                                "uncovered", "count", "cost", "share");
  for (std::size_t i = 0; i < kCauseCount; ++i)
    if (is_worth_a_row(why.causes.parts[i]))
      out += cause_row(static_cast<Cause>(i), why.causes.parts[i], cost);
  return out + runner_up_rows(why, cost) + longest_side_row(why.longest_side);
}

}  // namespace tramline::app
