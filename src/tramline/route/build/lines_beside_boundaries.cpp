#include "tramline/route/build/lines_beside_boundaries.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

/// Kept beside boundaries by lines that are no passes, m.
constexpr double kBesideBoundary_m = 0.1;

/// How far from its axle the outline gets to the outside of the tightest turn, m.
double outer_reach_m(const DrivingGround& ground) {
  const double radius_m = ground.machine().radius_m;
  double farthest_m = 0.5 * ground.machine().width_m;
  for (const std::vector<Box>* parts : {&ground.outline().on_machine, &ground.outline().on_implement})
    for (const Box& part : *parts)
      for (const Point corner : corners_of(part))
        farthest_m = std::max(farthest_m, std::hypot(radius_m + std::abs(corner.y), corner.x) - radius_m);
  return farthest_m;
}

/// One pass round every boundary that has none.
HeadlandTerms beside_bare_boundaries(const Headland& headland, const Field& field,
                                     const DrivingGround& ground) {
  HeadlandTerms terms;
  terms.width_m = 2 * (outer_reach_m(ground) + kBesideBoundary_m);
  terms.radius_m = ground.machine().radius_m;
  const bool round_field = std::any_of(headland.passes.begin(), headland.passes.end(),
                                       [](const auto& pass) { return pass.around_field && is_closed(pass); });
  terms.field_passes = round_field ? 0 : 1;
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    const bool has_passes = i < headland.obstacle_passes.size() && headland.obstacle_passes[i] > 0;
    terms.obstacle_passes.push_back(has_passes ? 0 : 1);
  }
  return terms;
}

}  // namespace

std::vector<FollowedLine> lines_beside_boundaries(const Headland& headland, const Field& field,
                                                  const DrivingGround& ground) {
  std::vector<FollowedLine> out;
  for (const HeadlandPass& line : headland_of(field, beside_bare_boundaries(headland, field, ground)).passes)
    out.push_back({steered(line.path), is_closed(line), false});
  return out;
}

const std::vector<FollowedLine>& LinesBesideBoundaries::found(const Headland& headland, const Field& field,
                                                              const DrivingGround& ground) const {
  const HeadlandTerms terms = beside_bare_boundaries(headland, field, ground);
  const std::lock_guard taken(taken_);
  assert(by_terms_.empty() || by_terms_.front().first.width_m == terms.width_m);
  const auto known =
      std::ranges::find(by_terms_, terms, &std::pair<HeadlandTerms, std::vector<FollowedLine>>::first);
  if (known != by_terms_.end()) return known->second;
  return by_terms_.emplace_back(terms, lines_beside_boundaries(headland, field, ground)).second;
}

const std::vector<FollowedLine>& LinesForNarrower::round_all(const Field& field,
                                                             const DrivingGround& narrowed) const {
  const std::lock_guard taken(taken_);
  const auto [entry, added] = by_width_m_.try_emplace(narrowed.machine().width_m);
  if (added) entry->second = lines_beside_boundaries({}, field, narrowed);
  return entry->second;
}

}  // namespace tramline
