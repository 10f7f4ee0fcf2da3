#include "tramline/planner/assembly/whole_figures.h"

#include <algorithm>

#include "tramline/cost/whole_tally.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/planner/assembly/driven_tracks.h"

namespace tramline {
namespace {

bool has_headland(const SearchTask& task) {
  return !task.headland.ground.empty() || !task.headland.passes.empty();
}

/// The area of the body that headland passes work.
double worked_of_body_m2(const SearchTask& task) {
  RisingCurves curves;
  Box window;
  for (const HeadlandPass& pass : task.headland.passes) {
    window.extend(reach_of(pass.path, task.machine.width_m));
    append_swath_area(pass.path, task.machine.width_m, Layer::kNew, curves);
  }
  for (const Ring& ring : rings_of(task.ground.body)) append_ring(ring, Layer::kBody, window, curves);
  return newly_covered_area(curves);
}

/// The cost of the best plan found that leaves the land undivided.
double undivided_cost(const SearchTask& task, const SearchResult& found, const Plan& plan) {
  if (found.undivided.empty()) return plan.cost;
  return cost_with_headland(task, candidate_on(task, found.undivided));
}

}  // namespace

Tally whole_tally_of(const SearchTask& task, const Candidate& candidate) {
  const Tally& tracks = candidate.avoided.tally;
  if (!has_headland(task)) return tracks;
  return whole_tally(tracks, track_pieces(task, candidate), task.ground.body, task.headland,
                     task.machine.width_m);
}

double cost_with_headland(const SearchTask& task, const Candidate& candidate) {
  return cost(task.objective, whole_tally_of(task, candidate));
}

void set_figures(Plan& plan, const Tally& tracks) {
  plan.track_tally = tracks;
  plan.tally = whole_tally(tracks, plan.pieces, plan.body, plan.headland, plan.machine.width_m);
  plan.cost = cost(plan.objective, plan.tally);
}

double least_by_headland(const SearchTask& task) {
  if (!has_headland(task)) return 0;
  const Objective& price = task.objective;
  const Headland& headland = task.headland;
  const double gained_m2 = headland.uncovered_m2 + worked_of_body_m2(task);
  return price.overlap * headland.overlap_m2 + price.uncovered * headland.uncovered_m2 -
         (price.overlap + price.uncovered) * gained_m2;
}

Proof whole_proof(const SearchTask& task, const SearchResult& found, const Plan& plan) {
  if (!has_headland(task) || found.proof.one_direction_cost == 0) return found.proof;
  const double added = least_by_headland(task);
  Proof out;
  out.prices = found.proof.prices;
  out.one_direction_cost = undivided_cost(task, found, plan);
  out.one_direction_bound = std::clamp(found.proof.one_direction_bound + added, 0.0, out.one_direction_cost);
  out.bound = std::clamp(found.proof.bound + added, 0.0, plan.cost);
  return out;
}

}  // namespace tramline
