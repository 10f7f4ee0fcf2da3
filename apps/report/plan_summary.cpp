#include "report/plan_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/report_parts.h"
#include "report/turning/route_report.h"
#include "report/turning/turning_report.h"
#include "tramline/model/plain_zero.h"
#include "tramline/planner/warnings.h"

namespace tramline::app {
namespace {

double distance_km(const Plan& plan) {
  double sum_m = length(plan.headland);
  for (const TrackPiece& piece : plan.pieces) sum_m += length(piece);
  return sum_m / 1e3;
}

std::string share_text(const Plan& plan, double part_m2) {
  const double land = land_m2(plan);
  return fmt::format("{:.1f} m² ({:.2f} %)", plain_zero(part_m2), land > 0 ? 100 * part_m2 / land : 0);
}

std::string counted(std::size_t number, std::string_view one, std::string_view several) {
  return fmt::format("{} {}", number, number == 1 ? one : several);
}

std::string ground_row(const Plan& plan) {
  const std::size_t obstacles = plan.field.obstacles.size();
  const std::string left_out =
      obstacles == 0 ? "" : " without its " + counted(obstacles, "obstacle", "obstacles");
  const char* what = is_repair(plan) ? "missed land in field" : "field";
  return fmt::format("to work      {:.4f} ha, {} {}{}\n", land_m2(plan) / 1e4, what, plan.field.id, left_out);
}

/// Of the subfields that have tracks, in their order.
std::vector<Direction> worked_directions(const Plan& plan) {
  std::vector<bool> worked(plan.subfields.size(), false);
  for (const TrackPiece& piece : plan.pieces) worked[piece.subfield] = true;
  std::vector<Direction> out;
  for (std::size_t i = 0; i < worked.size(); ++i)
    if (worked[i]) out.push_back(plan.subfields[i].direction);
  return out;
}

/// "74 tracks at 92.53° and 8 headland passes"
std::string tracks_and_passes_text(const Plan& plan) {
  constexpr std::size_t kShown = 4;
  const std::string kind = is_curved(plan) ? fmt::format("{} ", kind_of_tracks(plan)) : "";
  std::string out;
  if (!plan.pieces.empty())
    out = fmt::format("{} at {}", counted(plan.pieces.size(), kind + "track", kind + "tracks"),
                      directions_text(worked_directions(plan), kShown));
  const std::size_t round = plan.headland.passes.size();
  if (round == 0) return out;
  return out + (out.empty() ? "" : " and ") + counted(round, "headland pass", "headland passes");
}

std::string passes_row(const Plan& plan) {
  return fmt::format("passes       {}, each {:g} m wide: {}; {}, {}\n",
                     plan.pieces.size() + plan.headland.passes.size(), plan.machine.width_m,
                     tracks_and_passes_text(plan),
                     counted(static_cast<std::size_t>(plan.tally.turns), "turn", "turns"),
                     counted(stops(plan), "stop", "stops"));
}

/// What is odd about this plan or its field, the most important first. What holds for every plan is not odd.
std::vector<std::string> oddities(const Plan& plan, const std::vector<Skipped>& skipped) {
  std::vector<std::string> out = plan.warnings;
  std::erase(out, kConnectionsUnplanned);
  if (!plan.field.repairs.empty())
    out.push_back(counted(plan.field.repairs.size(), "fault of the field's outline was",
                          "faults of the field's outline were") +
                  " repaired");
  if (!skipped.empty())
    out.push_back(counted(skipped.size(), "part of the input was", "parts of the input were") +
                  " left aside");
  return out;
}

std::string note_row(const std::vector<std::string>& odd) {
  if (odd.empty()) return "note         nothing unusual\n";
  const std::string more = odd.size() == 1 ? ""
                                           : fmt::format(" (and {}: --explain)",
                                                         counted(odd.size() - 1, "more note", "more notes"));
  return fmt::format("note         {}{}\n", odd.front(), more);
}

/// By prices of the land, where they were asked for.
std::string prices_row(const Plan& plan) {
  const double bound = plan.proof.bound;
  if (plan.proof.prices.cells.empty() || bound <= 0 || plan.cost <= 0) return "";
  if (plan.cost <= bound) return "proven       no plan costs less\n";
  return fmt::format("proven       at most {:.1f} % above the best plan with any division\n",
                     std::ceil(1000 * (plan.cost / bound - 1)) / 10);
}

/// Empty where nothing is proven, or so little that it tells nobody anything.
std::string proof_row(const Plan& plan) {
  constexpr double kMostTold = 1;
  const double bound = plan.proof.one_direction_bound;
  if (!is_proven(plan) || bound <= 0 || plan.cost > (1 + kMostTold) * bound) return "";
  if (plan.cost <= bound) return "proven       no plan of one direction costs less\n";
  return fmt::format("proven       at most {:.1f} % above the best plan of one direction\n",
                     std::ceil(1000 * (plan.cost / bound - 1)) / 10);
}

std::string front_row(const Plan& plan) {
  if (plan.front.points.empty()) return "";
  return fmt::format("front        {} plans to choose from: see 'tramline compare'\n",
                     plan.front.points.size());
}

}  // namespace

bool is_proven(const Plan& plan) {
  const bool drawn = std::any_of(plan.subfields.begin(), plan.subfields.end(),
                                 [](const Subfield& subfield) { return !subfield.given_by.empty(); });
  return plan.settings.aim == Aim::kCost && plan.settings.strategy == Strategy::kBest &&
         references(plan).empty() && !is_repair(plan) && !drawn;
}

std::string figure_rows(const Plan& plan) {
  if (plan.route.planned())
    return whole_cost_row(plan) + ground_row(plan) + passes_row(plan) + turning_rows(plan) +
           route_rows(plan) +
           fmt::format("land         {} worked twice, {} missed\n", share_text(plan, plan.tally.overlap_m2),
                       share_text(plan, plan.tally.uncovered_m2));
  return ground_row(plan) + passes_row(plan) +
         fmt::format("distance     {:.3f} km at work\n", distance_km(plan)) + turning_rows(plan) +
         fmt::format("worked twice {}\n", share_text(plan, plan.tally.overlap_m2)) +
         fmt::format("missed       {}\n", share_text(plan, plan.tally.uncovered_m2));
}

std::string plan_summary(const Plan& plan, const std::vector<Skipped>& skipped) {
  return figure_rows(plan) + proof_row(plan) + prices_row(plan) + note_row(oddities(plan, skipped)) +
         front_row(plan);
}

std::string plan_line(const Plan& plan, double seconds) {
  const std::string unworked = unworked_land_warning(plan);
  return fmt::format(
      "{}: {:.4f} ha, {}, {:.3f} km, worked twice {}, missed {}, {}, {}, {:.3f} s{}\n", plan.field.id,
      land_m2(plan) / 1e4, counted(plan.pieces.size() + plan.headland.passes.size(), "pass", "passes"),
      distance_km(plan), share_text(plan, plan.tally.overlap_m2), share_text(plan, plan.tally.uncovered_m2),
      counted(static_cast<std::size_t>(plan.tally.turns), "turn", "turns"),
      counted(stops(plan), "stop", "stops"), seconds, unworked.empty() ? "" : "; " + unworked);
}

}  // namespace tramline::app
