#include "tramline/planner/best_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/planner/division.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/sweep_search.h"

namespace tramline {
namespace {

constexpr std::size_t kHinderedTries = 5;  ///< grids of either ranking that are tried with detours

GriddedSubfield gridded(const Polygon& shape, const PricedGrid& grid) {
  return {{shape, grid.direction}, grid.origin_m};
}

std::vector<GriddedSubfield> gridded(const std::vector<PricedSubfield>& subfields) {
  std::vector<GriddedSubfield> out;
  for (const PricedSubfield& subfield : subfields) out.push_back(gridded(subfield.shape, subfield.grid));
  return out;
}

/// Some ways of laying tracks over the same ground, and what each comes to.
struct Tried {
  std::vector<GriddedSubfield> grounds;
  Candidate candidate;
};

Tried cheapest_of(const SearchTask& task, std::vector<std::vector<GriddedSubfield>> ways, int threads) {
  std::vector<Candidate> candidates(ways.size());
  for_each_index(ways.size(), threads, [&](std::size_t i) { candidates[i] = candidate_on(task, ways[i]); });
  const auto best =
      std::min_element(candidates.begin(), candidates.end(),
                       [](const Candidate& a, const Candidate& b) { return a.cost() < b.cost(); });
  return {std::move(ways[static_cast<std::size_t>(best - candidates.begin())]), std::move(*best)};
}

/// One connected part of the ground, by itself.
struct PartResult {
  std::vector<GriddedSubfield> whole;   ///< undivided
  std::vector<GriddedSubfield> chosen;  ///< the same, or divided
  double bound = 0;                     ///< of undivided plans
  int boxes = 0;
};

PartResult search_part(const SearchTask& task, const Polygon& part, int threads) {
  SearchEffort effort;
  effort.tolerance = task.settings.direction_tolerance;
  const GridSearchResult found = search_grids(task, part, effort, threads);
  const bool hindered = !found.unhindered.empty();
  std::vector<std::vector<GriddedSubfield>> ways{{gridded(part, found.grids.front())}};
  for (std::size_t i = 0; hindered && i < kHinderedTries; ++i) {
    if (i > 0 && i < found.grids.size()) ways.push_back({gridded(part, found.grids[i])});
    if (i < found.unhindered.size()) ways.push_back({gridded(part, found.unhindered[i])});
  }
  Tried whole = cheapest_of(task, std::move(ways), threads);

  const PricedSubfield ground{part, hindered ? found.unhindered.front() : found.grids.front()};
  std::vector<PricedSubfield> divided = divide_where_it_pays(task, ground, threads);
  PartResult out{whole.grounds, whole.grounds, found.bound, found.boxes};
  if (divided.size() < 2) return out;
  if (divided.size() > 2) divided = join_where_it_pays(task, std::move(divided), threads);
  const Candidate apart = candidate_on(task, gridded(divided));
  if (apart.cost() < whole.candidate.cost()) out.chosen = gridded(divided);
  return out;
}

/// The sweep's subfields, each with the best grid, and joined where that pays.
std::vector<GriddedSubfield> regridded(const SearchTask& task, const std::vector<GriddedSubfield>& swept,
                                       int threads) {
  std::vector<PricedSubfield> subfields(swept.size());
  for_each_index(subfields.size(), threads,
                 [&](std::size_t i) { subfields[i] = priced(task, swept[i].subfield.shape, 1); });
  return gridded(join_where_it_pays(task, std::move(subfields), threads));
}

void keep_cheaper(Candidate& best, Candidate other) {
  if (other.cost() < best.cost()) best = std::move(other);
}

/// What a plan costs besides what its parts cost each by itself: the first track needs no turn.
double beside_the_parts(const SearchTask& task) {
  const double given_up_m2 = std::max(0.0, task.body_m2 - area(task.ground.plannable));
  return task.objective.uncovered * given_up_m2 - task.objective.turn;
}

}  // namespace

double least_cost_of_any_plan(const SearchTask& task) {
  const Objective& price = task.objective;
  const double width_m = task.machine.width_m, arc = std::max(task.machine.radius_m, 0.5 * width_m);
  const Box box = bounds(task.ground.plannable);
  double longest = std::hypot(box.width(), box.height());
  for (const Hazard& hazard : task.ground.hazards) {
    // Round an obstacle, at most: half a turn about it on either side and into and out of the arcs.
    const Box around = bounds(hazard.shape);
    longest += 2 * (around.width() + around.height()) + 4 * std::numbers::pi * (arc + width_m);
  }
  const double ground_m2 = std::min(task.body_m2, area(task.ground.plannable));
  const double given_up_m2 = std::max(0.0, task.body_m2 - area(task.ground.plannable));
  const double by_tracks = price.turn * std::max(0.0, ground_m2 / (width_m * longest) - 1);
  return price.uncovered * given_up_m2 + std::min(by_tracks, price.uncovered * ground_m2);
}

SearchResult best_search(const SearchTask& task, int threads, const Progress& progress) {
  const std::vector<SweptGround> swept = swept_grounds(task, threads, progress);
  std::vector<GriddedSubfield> whole, chosen;
  double bound = beside_the_parts(task);
  int boxes = 0;
  bool divided = false;
  for (const Polygon& part : task.ground.plannable) {
    const PartResult found = search_part(task, part, threads);
    whole.insert(whole.end(), found.whole.begin(), found.whole.end());
    chosen.insert(chosen.end(), found.chosen.begin(), found.chosen.end());
    divided = divided || found.chosen.size() > 1;
    bound += found.bound;
    boxes += found.boxes;
  }
  Candidate best = candidate_on(task, whole);
  SearchResult out;
  out.proof.one_direction_cost = best.cost();
  out.proof.one_direction_bound = std::clamp(bound, 0.0, best.cost());
  if (divided) keep_cheaper(best, candidate_on(task, chosen));
  const auto promising = std::min_element(
      swept.begin(), swept.end(),
      [](const SweptGround& a, const SweptGround& b) { return a.outlook.soft < b.outlook.soft; });
  if (promising->grounds.size() > task.ground.plannable.size())
    keep_cheaper(best, candidate_on(task, regridded(task, promising->grounds, threads)));
  if (std::optional<Candidate> sweep = cheapest_swept(task, swept, best.cost(), threads))
    best = std::move(*sweep);
  out.proof.bound = std::min(out.proof.one_direction_bound, least_cost_of_any_plan(task));
  out.directions_tried = static_cast<int>(swept.size()) + boxes;
  out.best = std::move(best);
  return out;
}

}  // namespace tramline
