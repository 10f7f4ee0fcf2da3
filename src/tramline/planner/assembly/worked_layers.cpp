#include "tramline/planner/assembly/worked_layers.h"

#include <utility>

#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/cost/worked/worked_regions.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/profile/path_profile.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/headland/body.h"
#include "tramline/headland/pass_ground.h"

namespace tramline {
namespace {

Region land_of(const Plan& plan) { return plan.headland.ground.empty() ? plan.body : body_of(plan.field); }

void append_common(const Region& a, const Region& b, Region& out) {
  if (!intersects(bounds(a), bounds(b))) return;
  for (Polygon& both : intersection(a, b))
    if (!is_sliver(both)) out.push_back(std::move(both));
}

/// Adds the passes of the headland to the land worked, and to the land worked twice.
void add_passes(const Plan& plan, TrackGround& all) {
  for (const HeadlandPass& pass : plan.headland.passes) {
    const Region parts = pass_ground_parts(pass.path, plan.machine.width_m, kLayerSagitta);
    if (parts.size() > 1)
      for (Polygon& both : common_to_two(parts))
        if (!is_sliver(both)) all.doubled.push_back(std::move(both));
    Region ground = unite(parts);
    for (const Region& other : all.regions) append_common(ground, other, all.doubled);
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
  Region worked;
  for (const Region& ground : tracks.regions) {
    worked.insert(worked.end(), ground.begin(), ground.end());
    for (Polygon& part : difference(reaching_out(ground, edges), land))
      tracks.doubled.push_back(std::move(part));
  }
  // In one go: taken away one by one, swaths leave thousands of slivers between the chords of their arcs.
  plan.uncovered = difference(land, unite(worked));
  std::erase_if(plan.uncovered, is_sliver);
  plan.overlap = unite(tracks.doubled);
}

}  // namespace tramline
