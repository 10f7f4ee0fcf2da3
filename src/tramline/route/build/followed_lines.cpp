#include "tramline/route/build/followed_lines.h"

#include <algorithm>
#include <cmath>

#include "tramline/headland/headland.h"
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

/// Of passes side by side those a radius or so apart, the innermost among them: what is between is reached
/// from these.
bool is_followed(const HeadlandPass& pass, const Headland& headland, const Machine& machine) {
  const int step = std::max(1, static_cast<int>(machine.radius_m / machine.width_m));
  int deepest = pass.number;
  for (const HeadlandPass& other : headland.passes) deepest = std::max(deepest, other.number);
  return (deepest - pass.number) % step == 0;
}

}  // namespace

std::vector<FollowedLine> followed_lines(const Headland& headland, const std::vector<TrackPiece>& pieces,
                                         const Field& field, const DrivingGround& ground) {
  const Turning& turning = ground.machine().turning;
  std::vector<FollowedLine> out;
  for (const HeadlandPass& pass : headland.passes) {
    if (!is_followed(pass, headland, ground.machine())) continue;
    const bool closed = is_closed(pass);
    out.push_back(
        {closed ? closed_axle_path(pass.path, 0, turning) : axle_path(pass.path, turning), closed, false});
  }
  for (const HeadlandPass& line : headland_of(field, beside_bare_boundaries(headland, field, ground)).passes)
    out.push_back({steered(line.path), is_closed(line), false});
  for (const TrackPiece& piece : pieces) out.push_back({axle_path(piece, turning), false, true});
  return out;
}

}  // namespace tramline
