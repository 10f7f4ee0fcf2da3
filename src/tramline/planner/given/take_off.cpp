#include "tramline/planner/given/take_off.h"

#include <fmt/format.h>

#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/given/narrow_tails.h"
#include "tramline/planner/given/sliver_part.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

constexpr double kBesideDone_m = 0.01;  ///< land nearer than this to land done lies beside it

Error nothing_remains(const PlanningProblem& problem) {
  const GivenLand& given = problem.settings.given;
  const std::string& field = problem.field.id;
  if (!given.done.empty())
    return bad_input(fmt::format(
        "nothing of field '{}' is left to plan: what --done has not covered is smaller than {:g} m² or "
        "narrower than the working width of {:g} m; 'tramline repair' plans passes over such gaps",
        field, problem.settings.small_cell_m2, problem.machine.width_m));
  if (!given.elsewhere.empty())
    return bad_input(fmt::format("no land to work of field '{}' lies in the polygons of --only", field));
  return bad_input(
      fmt::format("nothing of field '{}' is left to plan: --subfields leaves out all of it", field));
}

/// The land beside land done that is not worth planning: parts that are slivers, and the tails of others,
/// where so little of a swath would have land to work that not even the cheapest end rule begins one.
Region leftovers(const PlanningProblem& problem, const Region& plannable) {
  Region out;
  const Region& done = problem.settings.given.done;
  if (done.empty()) return out;
  const double width_m = problem.machine.width_m;
  constexpr double kNarrow_share = 1.0 / 6;
  const auto beside_done = [&done](const Polygon& land) {
    return distance_between({land}, done) <= kBesideDone_m;
  };
  for (const Polygon& part : plannable) {
    if (!beside_done(part)) continue;
    if (is_sliver_part(problem, part)) {
      out.push_back(part);
      continue;
    }
    for (Polygon& tail : narrow_tails(part, kNarrow_share * width_m, width_m))
      if (beside_done(tail)) out.push_back(std::move(tail));
  }
  return out;
}

void remark_leftovers(const Region& left, PreparedLand& out) {
  constexpr double kWorthSaying_m2 = 0.05;
  if (area(left) < kWorthSaying_m2) return;
  const bool one = left.size() == 1;
  out.remarks.push_back(
      fmt::format("{} part{} of what --done leaves, {:.1f} m² in all, {} too small or too narrow to plan and "
                  "stay{} unworked; "
                  "'tramline repair' plans passes over gaps",
                  left.size(), one ? "" : "s", area(left), one ? "is" : "are", one ? "s" : ""));
}

void take_off_worked(const PlanningProblem& problem, ClassifiedGround& ground, PreparedLand& out) {
  const GivenLand& given = problem.settings.given;
  Region off = unite(unite(given.done), unite(given.elsewhere));
  Region plannable = difference(ground.plannable, off);
  drop_specks(plannable);
  const Region left = leftovers(problem, plannable);
  remark_leftovers(left, out);
  if (!left.empty()) {
    off = unite(off, unite(left));
    plannable = difference(plannable, left);
    drop_specks(plannable);
  }
  if (area(plannable) < kNoGround_m2) throw nothing_remains(problem);
  Region body = difference(ground.body, off);
  drop_specks(body);
  out.worked = difference(ground.body, body);
  drop_specks(out.worked);
  ground.body = std::move(body);
  ground.plannable = std::move(plannable);
  // No swath enters land given up that is not to be worked either, but an end there is not a stop.
  const Region in_worked = difference(ground.given_up, ground.body);
  if (!in_worked.empty()) {
    ground.beyond = unite(ground.beyond, in_worked);
    ground.hard = difference(ground.hard, in_worked);
  }
  ground.given_up = intersection(ground.given_up, ground.body);
}

void take_off_left_out(const PlanningProblem& problem, ClassifiedGround& ground, PreparedLand& out) {
  Region left_out = intersection(problem.settings.given.left_out, ground.body);
  if (!left_out.empty() && !ground.given_up.empty()) left_out = difference(left_out, ground.given_up);
  drop_specks(left_out);
  if (left_out.empty()) return;
  ground.plannable = difference(ground.plannable, problem.settings.given.left_out);
  drop_specks(ground.plannable);
  if (area(ground.plannable) < kNoGround_m2) throw nothing_remains(problem);
  ground.hard = unite(ground.hard, left_out);
  for (const Polygon& part : left_out) ground.hazards.push_back({part, {}, {}});
  out.left_out = left_out.size();
  ground.given_up.insert(ground.given_up.end(), left_out.begin(), left_out.end());
}

}  // namespace

void take_off_given(const PlanningProblem& problem, ClassifiedGround& ground, PreparedLand& out) {
  const GivenLand& given = problem.settings.given;
  if (!given.done.empty() || !given.elsewhere.empty()) take_off_worked(problem, ground, out);
  if (!given.left_out.empty()) take_off_left_out(problem, ground, out);
}

}  // namespace tramline
