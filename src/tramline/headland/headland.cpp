#include "tramline/headland/headland.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/headland/ceded_to_tracks.h"
#include "tramline/headland/edges/chain_passes.h"
#include "tramline/headland/pass_boundaries.h"
#include "tramline/headland/pass_rings.h"
#include "tramline/headland/pass_tally.h"
#include "tramline/headland/plain/plain_headland.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

Region body_behind(const Field& field, const Region& land, const std::vector<Boundary>& boundaries,
                   double width_m) {
  Region behind = land_behind_headlands(boundaries, width_m);
  const Region inside = land_inside_obstacles(field, boundaries);
  if (!inside.empty()) behind = unite(behind, inside);
  if (boundaries.front().passes > 0 && field.obstacles.empty()) return behind;
  return intersection(land, behind);
}

/// Passes along chains of edges, from the first number that not all edges of the field have.
struct ChainsByNumber {
  int first = 1;
  std::vector<std::vector<ChainToFollow>> chains;  ///< of number first + i

  const std::vector<ChainToFollow>& with(int number) const {
    static const std::vector<ChainToFollow> kNone;
    const int i = number - first;
    return i < 0 || i >= std::ssize(chains) ? kNone : chains[static_cast<std::size_t>(i)];
  }
  int last() const { return first - 1 + static_cast<int>(chains.size()); }
  Region ground() const {
    Region out;
    for (const auto& same_number : chains)
      for (const ChainToFollow& chain : same_number)
        out.insert(out.end(), chain.ground.land.begin(), chain.ground.land.end());
    return unite(out);
  }
};

ChainsByNumber chains_of(const Field& field, const HeadlandTerms& terms) {
  ChainsByNumber out;
  out.first = 1 + passes_everywhere(terms.edge_passes);
  for (int number = out.first; number <= passes_anywhere(terms.edge_passes); ++number) {
    out.chains.emplace_back();
    for (EdgeChain& chain : chains_with(field.outer, terms.edge_passes, number)) {
      ChainGround ground = ground_along(chain, field.outer, number * terms.width_m);
      out.chains.back().push_back({std::move(chain), std::move(ground)});
    }
  }
  return out;
}

double least_track_m(const HeadlandTerms& terms) { return std::max(terms.min_length_m, 2 * terms.width_m); }

/// Takes the ground of chains off the body, and the parts of it beside them where no track fits. Returns
/// these parts.
Region take_chains_off(const ChainsByNumber& chains, const HeadlandTerms& terms, Region& body) {
  const Region ground = chains.ground();
  if (ground.empty()) return {};
  body = difference(body, ground);
  Region narrow = without_room_for_tracks(body, terms.width_m, least_track_m(terms));
  std::erase_if(narrow, [&](const Polygon& part) { return distance_between({part}, ground) > kSamePlace_m; });
  if (!narrow.empty()) body = difference(body, narrow);
  return narrow;
}

/// The land where tracks may end in any direction, a width and the clearance from every boundary that has
/// passes, and where they may also reach over the edge of their ground, as far from every boundary. Neither
/// includes the ground of chains.
ClearLand clear_of_boundaries(std::vector<Boundary> boundaries, const ChainsByNumber& chains,
                              double width_m) {
  bool all = true;
  for (Boundary& boundary : boundaries) {
    all = all && boundary.passes > 0;
    boundary.passes = std::min(boundary.passes, 1);
  }
  ClearLand out;
  out.for_track_ends = land_behind_headlands(boundaries, width_m);
  for (Boundary& boundary : boundaries) boundary.passes = 1;
  out.for_track_sides = all ? out.for_track_ends : land_behind_headlands(boundaries, width_m);
  Region taken;
  for (const ChainToFollow& chain : chains.with(1))
    taken.insert(taken.end(), chain.ground.land.begin(), chain.ground.land.end());
  if (taken.empty()) return out;
  taken = unite(taken);
  out.for_track_ends = difference(out.for_track_ends, taken);
  out.for_track_sides = difference(out.for_track_sides, taken);
  return out;
}

/// Leaves ground that no pass works to tracks. Parts of the land taken off the body for want of room go back
/// to it whole where a track has room on them together with such ground.
void leave_to_tracks(const Field& field, const Region& land, const ClearLand& clear, Region taken_off,
                     const HeadlandTerms& terms, HeadlandAndBody& out) {
  const double w = terms.width_m;
  const Region ceded = ceded_to_tracks(out, clear, w, least_track_m(terms));
  if (ceded.empty()) return;
  std::erase_if(taken_off, [&](const Polygon& part) { return intersection({part}, ceded).empty(); });
  out.body = unite(out.body, taken_off.empty() ? ceded : unite(ceded, taken_off));
  out.ground = difference(land, out.body);
  tally_passes(obstacle_shapes(field, ObstacleKind::kPassable), w, out);
}

int deepest(const std::vector<Boundary>& boundaries) {
  int out = 0;
  for (const Boundary& boundary : boundaries) out = std::max(out, boundary.passes);
  return out;
}

bool leaves_body(const Field& field, double width_m, int passes) {
  const auto boundaries = boundaries_of(field, {width_m, 0, passes, {}});
  return !body_behind(field, body_of(field), boundaries, width_m).empty();
}

}  // namespace

HeadlandAndBody headland_of(const Field& field, const HeadlandTerms& asked) {
  assert(asked.edge_passes.empty() || asked.edge_passes.size() == field.outer.size());
  HeadlandTerms terms = asked;
  if (!terms.edge_passes.empty()) terms.field_passes = passes_everywhere(terms.edge_passes);
  if (terms.field_passes == passes_anywhere(terms.edge_passes)) terms.edge_passes.clear();
  if (terms.construction == HeadlandConstruction::kPlain) return plain_headland_of(field, terms);
  const std::vector<Boundary> boundaries = boundaries_of(field, terms);
  const Region land = body_of(field);
  HeadlandAndBody out;
  out.obstacle_passes = terms.obstacle_passes;
  out.edge_passes = terms.edge_passes;
  const ChainsByNumber chains = chains_of(field, terms);
  const int most = std::max(deepest(boundaries), chains.last());
  if (most == 0) {
    out.body = land;
    return out;
  }
  out.body = body_behind(field, land, boundaries, terms.width_m);
  Region taken_off = take_chains_off(chains, terms, out.body);
  out.ground = difference(land, out.body);
  const Region passable = obstacle_shapes(field, ObstacleKind::kPassable);
  const auto add = [&](std::vector<HeadlandPass> passes) {
    out.passes.insert(out.passes.end(), std::make_move_iterator(passes.begin()),
                      std::make_move_iterator(passes.end()));
  };
  for (int number = 1; number <= most; ++number) {
    for (const ChainToFollow& chain : chains.with(number))
      add(passes_along(chain, boundaries, terms, number, passable, out.passes));
    add(pass_rings(boundaries, terms, number, {out.ground, passable, terms.width_m}, out.passes));
  }
  tally_passes(passable, terms.width_m, out);
  if (out.uncovered_m2 > 0)
    leave_to_tracks(field, land, clear_of_boundaries(boundaries, chains, terms.width_m), std::move(taken_off),
                    terms, out);
  return out;
}

int most_passes(const Field& field, double width_m) {
  const Box reach = bounds(field.outer);
  int fits = 0, too_many = 1 + static_cast<int>(0.5 * std::min(reach.width(), reach.height()) / width_m);
  while (too_many - fits > 1) {
    const int middle = fits + (too_many - fits) / 2;
    (leaves_body(field, width_m, middle) ? fits : too_many) = middle;
  }
  return fits;
}

}  // namespace tramline
