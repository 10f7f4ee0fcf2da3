#include "tramline/planner/repair/repair_plan.h"

#include <fmt/format.h>
#include "tramline/planner/repair/repair_choice.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tramline/cost/worked/piece_overlap.h"
#include "tramline/cost/worked/worked_regions.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/repair/line_positions.h"
#include "tramline/planner/repair/repair_pieces.h"
#include "tramline/planner/tolerances.h"
#include "tramline/planner/warnings.h"

namespace tramline {
namespace {

/// The gaps that are large enough; the others are listed.
std::vector<Gap> large_ones(const std::vector<Gap>& gaps, double min_area_m2,
                            std::vector<UnworkedGap>& ignored) {
  std::vector<Gap> out;
  for (const Gap& gap : gaps) {
    if (gap.area_m2 >= min_area_m2)
      out.push_back(gap);
    else
      ignored.push_back({gap.number, gap.area_m2, gap.centre,
                         fmt::format("smaller than the least area of {:g} m²", min_area_m2)});
  }
  return out;
}

/// The best pass over one gap alone.
std::optional<RepairLine> best_pass_over(std::size_t gap, const RepairGround& ground, EndRule end_rule) {
  std::optional<RepairLine> best;
  for (const LinePosition& position : line_positions_over(gap, ground))
    for (RepairLine& line : ground.lines_over(gap, position, end_rule))
      if (!best || line.worth > best->worth) best = std::move(line);
  return best;
}

/// The reason why a gap is not worked: the saving and cost of the best pass over it alone; nullopt: no pass
/// fits in.
std::optional<std::string> price_of_pass(std::size_t gap, const RepairGround& ground) {
  const Objective& objective = ground.terms().objective;
  std::optional<RepairLine> best = best_pass_over(gap, ground, ground.terms().end_rule);
  // A gap that is too slim for the end rule to begin a swath can still be entered.
  if (!best) best = best_pass_over(gap, ground, EndRule::kCover);
  if (!best) return std::nullopt;
  return fmt::format("a pass over {:.1f} m² of it costs {:.2f} with the turn to it and wins back {:.2f}",
                     best->line.covered_m2, price_of(best->line, ground.terms()) + objective.turn,
                     objective.uncovered * best->line.covered_m2);
}

std::string why_unreachable(const RepairGround& ground) {
  return fmt::format(
      "the machine cannot enter: no straight swath {:g} m wide in a direction driven there stays in the "
      "field "
      "and out of obstacles",
      ground.terms().machine.width_m);
}

/// Indices of the gaps that the lines work; the others are listed.
std::vector<std::size_t> gaps_worked_on(const std::vector<Gap>& gaps, const RepairGround& ground,
                                        const SearchContext& context, RepairPlan& out) {
  std::vector<std::size_t> worked_gaps, unworked;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    (area(ground.gap(i)) - area(ground.open(i)) > kByChance_m2 ? worked_gaps : unworked).push_back(i);
  std::vector<std::optional<std::string>> prices(unworked.size());
  for_each_index(unworked.size(), context,
                 [&](std::size_t k) { prices[k] = price_of_pass(unworked[k], ground); });
  for (std::size_t k = 0; k < unworked.size(); ++k) {
    const Gap& gap = gaps[unworked[k]];
    if (prices[k])
      out.not_worth.push_back({gap.number, gap.area_m2, gap.centre, *prices[k]});
    else
      out.unreachable.push_back({gap.number, gap.area_m2, gap.centre, why_unreachable(ground)});
  }
  return worked_gaps;
}

void require_gaps(const std::vector<Gap>& all, const std::vector<Gap>& large, const Field& field,
                  double min_area_m2) {
  if (all.empty()) throw bad_input(fmt::format("nothing of the field '{}' was missed", field.id));
  if (large.empty())
    throw bad_input(fmt::format(
        "none of the {} gaps of field '{}' can be repaired: all are smaller than {:g} m²; use a smaller "
        "--min-area",
        all.size(), field.id, min_area_m2));
}

void require_passes(const RepairPlan& repair, const RepairGround& ground, const Field& field) {
  if (repair.worked_gaps > 0) return;
  const double width_m = ground.terms().machine.width_m;
  if (repair.not_worth.empty())
    throw bad_input(fmt::format(
        "none of the {} gaps of field '{}' can be repaired: {} are too small, and into {} no swath "
        "{:g} m wide fits without leaving the field; use a smaller --min-area or a narrower machine",
        repair.gaps, field.id, repair.ignored.size(), repair.unreachable.size(), width_m));
  const UnworkedGap& largest = repair.not_worth.front();
  throw bad_input(fmt::format(
      "none of the {} gaps of field '{}' is worth a pass: left as they are they cost {:.2f}, and any pass "
      "costs "
      "more than it wins back (gap {}, {:.1f} m²: {}); --prices says what missed land and passes cost",
      repair.gaps, field.id, repair.cost_if_left, largest.number, largest.area_m2, largest.why));
}

/// The plan without pieces: body, worked land and the request.
Plan bare_plan(const Field& field, const std::vector<std::size_t>& worked_gaps, const RepairGround& ground) {
  Plan plan;
  plan.field = field;
  plan.machine = ground.terms().machine;
  plan.objective = ground.terms().objective;
  plan.settings.end_rule = ground.terms().end_rule;
  plan.settings.boundary = EdgeKind::kHard;
  plan.settings.avoid = Avoidance::kCut;
  plan.kind = PlanKind::kRepair;
  for (const std::size_t i : worked_gaps) plan.body.push_back(ground.gap(i));
  plan.body = unite(plan.body);
  plan.worked = difference(ground.free(), plan.body);
  std::erase_if(plan.worked, [](const Polygon& polygon) { return area(polygon) < kNoGround_m2; });
  if (plan.worked.empty())
    throw bad_input(fmt::format(
        "nothing of the field '{}' was worked: there is nothing to repair, plan it with 'tramline plan'",
        field.id));
  return plan;
}

void add_tally(Plan& plan) {
  Tally& tally = plan.tally;
  const double width_m = plan.machine.width_m;
  const std::vector<double> overlaps = overlap_by_piece(plan.body, plan.subfields, plan.pieces, width_m);
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    TrackPiece& piece = plan.pieces[i];
    piece.overlap_m2 = overlaps[i];
    tally.overlap_m2 += overlaps[i];
    tally.track_length_m += length(piece);
    tally.crossings += piece.after_crossing ? 1 : 0;
    tally.stops += (piece.stop_at_start ? 1 : 0) + (piece.stop_at_end ? 1 : 0);
  }
  tally.pieces = static_cast<int>(plan.pieces.size());
  tally.subfields = plan.pieces.empty() ? 0 : 1;
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  tally.worked_m2 = width_m * tally.track_length_m;
  tally.uncovered_m2 = std::max(0.0, area(plan.body) - (tally.worked_m2 - tally.overlap_m2));
  plan.track_tally = tally;
  plan.cost = cost(plan.objective, tally);
}

Region all_swaths(const std::vector<RepairLine>& lines) {
  Region out;
  for (const RepairLine& line : lines) out.insert(out.end(), line.swaths.begin(), line.swaths.end());
  return out;
}

void add_prices(RepairPlan& repair) {
  const Objective& objective = repair.plan.objective;
  const double way_to_the_first = objective.turn;
  repair.cost_of_passes =
      way_to_the_first + repair.plan.cost - objective.uncovered * repair.plan.tally.uncovered_m2;
  repair.cost_after = repair.cost_of_passes + objective.uncovered * repair.missed_after_m2;
}

}  // namespace

RepairPlan repair_plan(const Field& field, const std::vector<Gap>& gaps, const Region& missed,
                       const std::vector<DrivenLine>& driven, RepairTerms terms, double min_area_m2,
                       int threads, const Progress& progress) {
  if (terms.machine.min_length_m < 0) terms.machine.min_length_m = 0;
  const SearchContext context(threads, progress);
  RepairPlan out;
  const std::vector<Gap> large = large_ones(gaps, min_area_m2, out.ignored);
  require_gaps(gaps, large, field, min_area_m2);
  const double width_m = terms.machine.width_m;
  RepairGround ground(field, large, driven_directions(large, driven, width_m), std::move(terms));
  const std::vector<RepairLine> lines = chosen_lines(ground, context);
  const std::vector<std::size_t> worked_gaps = gaps_worked_on(large, ground, context, out);
  out.gaps = static_cast<int>(gaps.size());
  out.worked_gaps = static_cast<int>(worked_gaps.size());
  out.missed_before_m2 = area(missed);
  out.cost_if_left = ground.terms().objective.uncovered * out.missed_before_m2;
  require_passes(out, ground, field);

  out.plan = bare_plan(field, worked_gaps, ground);
  add_lines(out.plan, worked_gaps, lines, ground);
  add_tally(out.plan);
  const Region swaths = all_swaths(lines);
  WorkedRegions worked = worked_regions(out.plan.body, swaths);
  out.plan.overlap = std::move(worked.overlap);
  out.plan.uncovered = std::move(worked.uncovered);
  out.plan.warnings = warnings_about(out.plan);
  if (context.cut_short()) mark_cut_short(out.plan);
  out.missed_after_m2 = area(difference(missed, unite(swaths)));
  add_prices(out);
  return out;
}

}  // namespace tramline
