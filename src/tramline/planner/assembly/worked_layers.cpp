#include "tramline/planner/assembly/worked_layers.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/cost/worked/swath_union.h"
#include "tramline/cost/worked/worked_regions.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/profile/path_profile.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/headland/body.h"
#include "tramline/headland/pass_ground.h"
#include "tramline/planner/assembly/arc_slivers.h"
#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

Region land_of(const Plan& plan) { return plan.headland.ground.empty() ? plan.body : body_of(plan.field); }

/// What a pass works, and what its own parts work twice.
struct PassLand {
  Region ground;
  Region doubled;
};

PassLand land_of_pass(const HeadlandPass& pass, double width_m) {
  PassLand out;
  const Region parts = pass_ground_parts(pass.path, width_m, kLayerSagitta);
  if (parts.size() > 1) out.doubled = common_to_two(parts);
  std::erase_if(out.doubled, is_sliver);
  out.ground = unite(parts);
  return out;
}

/// Adds the passes of the headland to the land worked, and to the land worked twice.
void add_passes(const Plan& plan, const SearchContext& context, TrackGround& all) {
  const std::vector<HeadlandPass>& passes = plan.headland.passes;
  std::vector<PassLand> found(passes.size());
  for_each_index(passes.size(), context,
                 [&](std::size_t i) { found[i] = land_of_pass(passes[i], plan.machine.width_m); });
  const std::size_t first = all.regions.size();
  for (PassLand& pass : found) {
    all.regions.push_back(std::move(pass.ground));
    all.doubled.insert(all.doubled.end(), std::make_move_iterator(pass.doubled.begin()),
                       std::make_move_iterator(pass.doubled.end()));
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // of each pass, with all regions before it
  for (std::size_t i = first; i < all.regions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) pairs.emplace_back(i, j);
  const std::size_t before = all.also_doubled.size();
  all.also_doubled.resize(before + pairs.size());
  for_each_index(pairs.size(), context, [&](std::size_t k) {
    const auto [i, j] = pairs[k];
    all.also_doubled[before + k] = common_land(all.regions[i], all.regions[j]);
  });
}

/// The polygons that do not lie wholly inside the land.
Region reaching_out(const Region& parts, const EdgeIndex& land) {
  Region out;
  for (const Polygon& part : parts) {
    bool meets = !land.contains(part.outer.front());
    land.grid().each_meeting(bounds(part), [&meets](std::size_t) { meets = true; });
    if (meets) out.push_back(part);
  }
  return out;
}

}  // namespace

void add_layers(Plan& plan, TrackGround tracks, const SearchContext& context) {
  add_passes(plan, context, tracks);
  const Region land = land_of(plan);
  const EdgeIndex edges(land);
  const auto uncovered = [&] {
    // In one go: taken away one by one, swaths leave thousands of slivers between the chords of their arcs.
    plan.uncovered = difference(land, united_regions(tracks.regions));
    drop_slivers_along_arcs(plan, plan.uncovered);
  };
  const auto overlap = [&] {
    std::vector<Region> all = std::move(tracks.also_doubled);
    all.push_back(unite(tracks.doubled));
    for (const Region& ground : tracks.regions) all.push_back(difference(reaching_out(ground, edges), land));
    plan.overlap = united_regions(std::move(all));
  };
  side_by_side(context, uncovered, overlap);
}

}  // namespace tramline
