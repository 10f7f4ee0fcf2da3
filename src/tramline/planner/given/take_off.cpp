#include "tramline/planner/given/take_off.h"

#include <fmt/format.h>

#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/given/sliver_part.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

void drop_specks(Region& region) {
  std::erase_if(region, [](const Polygon& polygon) { return area(polygon) < kNoGround_m2; });
}

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

/// The parts beside land done that are not worth planning.
Region leftovers(const PlanningProblem& problem, const Region& plannable) {
  Region out;
  const Region& done = problem.settings.given.done;
  if (done.empty()) return out;
  for (const Polygon& part : plannable)
    if (is_sliver_part(problem, part) && distance_between({part}, done) <= kSamePlace_m) out.push_back(part);
  return out;
}

void remark_leftovers(const PlanningProblem& problem, const Region& left, PreparedLand& out) {
  if (left.empty()) return;
  out.remarks.push_back(fmt::format(
      "{} part{} of what --done leaves, {:.1f} m² in all, {} smaller than {:g} m² or narrower than the "
      "working width and stay{} unplanned; 'tramline repair' plans passes over gaps",
      left.size(), left.size() == 1 ? "" : "s", area(left), left.size() == 1 ? "is" : "are",
      problem.settings.small_cell_m2, left.size() == 1 ? "s" : ""));
}

void take_off_worked(const PlanningProblem& problem, ClassifiedGround& ground, PreparedLand& out) {
  const GivenLand& given = problem.settings.given;
  Region off = unite(unite(given.done), unite(given.elsewhere));
  Region plannable = difference(ground.plannable, off);
  drop_specks(plannable);
  const Region left = leftovers(problem, plannable);
  remark_leftovers(problem, left, out);
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
