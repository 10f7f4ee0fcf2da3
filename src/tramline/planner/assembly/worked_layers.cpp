#include "tramline/planner/assembly/worked_layers.h"

#include <utility>

#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/cost/worked/swath_union.h"
#include "tramline/cost/worked/worked_regions.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/profile/path_profile.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/headland/body.h"
#include "tramline/headland/pass_ground.h"

namespace tramline {
namespace {

Region land_of(const Plan& plan) { return plan.headland.ground.empty() ? plan.body : body_of(plan.field); }

/// Adds the passes of the headland to the land worked, and to the land worked twice.
void add_passes(const Plan& plan, TrackGround& all) {
  for (const HeadlandPass& pass : plan.headland.passes) {
    const Region parts = pass_ground_parts(pass.path, plan.machine.width_m, kLayerSagitta);
    if (parts.size() > 1)
      for (Polygon& both : common_to_two(parts))
        if (!is_sliver(both)) all.doubled.push_back(std::move(both));
    Region ground = unite(parts);
    for (const Region& other : all.regions) all.also_doubled.push_back(common_land(ground, other));
    all.regions.push_back(std::move(ground));
  }
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

void add_layers(Plan& plan, TrackGround tracks) {
  add_passes(plan, tracks);
  const Region land = land_of(plan);
  const EdgeIndex edges(land);
  std::vector<Region> overlap = std::move(tracks.also_doubled);
  overlap.push_back(unite(tracks.doubled));
  for (const Region& ground : tracks.regions)
    overlap.push_back(difference(reaching_out(ground, edges), land));
  plan.overlap = united_regions(std::move(overlap));
  // In one go: taken away one by one, swaths leave thousands of slivers between the chords of their arcs.
  plan.uncovered = difference(land, united_regions(std::move(tracks.regions)));
  std::erase_if(plan.uncovered, is_sliver);
}

}  // namespace tramline
