#include "tramline/planner/repair_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tramline/cost/piece_overlap.h"
#include "tramline/cost/worked_regions.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/gap_pieces.h"
#include "tramline/planner/join_gaps.h"
#include "tramline/planner/order/best_tour.h"
#include "tramline/planner/pulse.h"
#include "tramline/planner/warnings.h"

namespace tramline {
namespace {

void require_any(const GapsTakenOn& gaps, const Field& field, const RepairGround& ground) {
  const std::size_t all = gaps.taken.size() + gaps.ignored.size() + gaps.unreachable.size();
  if (all == 0) throw bad_input(fmt::format("nothing of the field '{}' was missed", field.id));
  if (!gaps.taken.empty()) return;
  throw bad_input(fmt::format(
      "none of the {} gaps of field '{}' can be repaired: {} are smaller than {:g} m², and into {} no swath "
      "{:g} m wide fits without leaving the field; use a smaller --min-area or a narrower machine",
      all, field.id, gaps.ignored.size(), ground.min_area_m2, gaps.unreachable.size(),
      ground.terms.machine.width_m));
}

/// Without pieces: body, worked ground and what was asked for.
Plan bare_plan(const Field& field, const std::vector<Gap>& taken, const RepairGround& ground) {
  Plan plan;
  plan.field = field;
  plan.machine = ground.terms.machine;
  plan.objective = ground.terms.objective;
  plan.settings.end_rule = ground.terms.end_rule;
  plan.settings.boundary = EdgeKind::kHard;
  plan.settings.avoid = Avoidance::kCut;
  for (const Gap& gap : taken) plan.body.push_back(oriented(gap.shape));
  plan.body = unite(plan.body);
  plan.worked = sized(difference(ground.free, plan.body), kNoGround_m2);
  if (plan.worked.empty())
    throw bad_input(fmt::format(
        "nothing of the field '{}' was worked: there is nothing to repair, plan it with 'tramline plan'",
        field.id));
  return plan;
}

/// The regions without those of the grounds that came of them, a subfield for each polygon, and the index of
/// the first for each ground.
std::vector<int> add_subfields(Plan& plan, const std::vector<RepairedGround>& grounds) {
  std::vector<int> first;
  for (const RepairedGround& ground : grounds) {
    Region own =
        ground.left_for_more.empty() ? ground.region : difference(ground.region, unite(ground.left_for_more));
    std::stable_sort(own.begin(), own.end(),
                     [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
    first.push_back(static_cast<int>(plan.subfields.size()));
    for (std::size_t i = 0; i < own.size(); ++i)
      if (i == 0 || area(own[i]) >= kNoGround_m2)
        plan.subfields.push_back({std::move(own[i]), ground.direction});
  }
  return first;
}

void add_pieces(Plan& plan, const std::vector<RepairedGround>& grounds) {
  const std::vector<int> first = add_subfields(plan, grounds);
  std::vector<TrackPiece> pieces;
  for (std::size_t i = 0; i < grounds.size(); ++i) append_pieces(grounds[i].lines, first[i], pieces);
  const std::vector<order::WorkedLine> lines = order::lines_of(pieces);
  plan.pieces = order::pieces_on(order::best_tour(lines, plan.field, plan.machine.width_m), lines);
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

void add_layers(Plan& plan, const Region& swaths) {
  WorkedRegions worked = worked_regions(plan.body, swaths);
  plan.overlap = std::move(worked.overlap);
  plan.uncovered = std::move(worked.uncovered);
}

}  // namespace

RepairPlan repair_plan(const Field& field, const std::vector<Gap>& gaps, const Region& missed,
                       RepairTerms terms, double min_area_m2, int threads, const RepairProgress& progress) {
  if (terms.machine.min_length_m < 0) terms.machine.min_length_m = 0;
  Pulse pulse(progress);
  const RepairGround ground = repair_ground(field, terms, min_area_m2);
  GapsTakenOn sorted = enterable_gaps(gaps, ground, threads);
  require_any(sorted, field, ground);
  std::vector<GapGroup> groups =
      join_where_it_pays(std::move(sorted.groups), ground.free, ground.obstacles, terms, threads);
  RepairLines lines = repair_lines(std::move(groups), sorted.taken, ground, pulse.counter());

  RepairPlan out;
  out.plan = bare_plan(field, sorted.taken, ground);
  add_pieces(out.plan, lines.grounds);
  add_tally(out.plan);
  add_layers(out.plan, lines.swaths);
  out.plan.warnings = warnings_about(out.plan);
  out.gaps = static_cast<int>(gaps.size());
  out.taken = static_cast<int>(sorted.taken.size());
  out.ignored = std::move(sorted.ignored);
  out.unreachable = std::move(sorted.unreachable);
  for (LeftGap& part : lines.unreachable) out.unreachable.push_back(std::move(part));
  out.missed_before_m2 = area(missed);
  out.missed_after_m2 = area(difference(missed, unite(lines.swaths)));
  return out;
}

}  // namespace tramline
