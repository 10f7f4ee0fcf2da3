#include "tramline/route/build/followed_lines.h"

#include <algorithm>

#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

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
                                         const std::vector<FollowedLine>& beside, const Machine& machine) {
  const Turning& turning = machine.turning;
  std::vector<FollowedLine> out;
  for (const HeadlandPass& pass : headland.passes) {
    if (!is_followed(pass, headland, machine)) continue;
    const bool closed = is_closed(pass);
    out.push_back(
        {closed ? closed_axle_path(pass.path, 0, turning) : axle_path(pass.path, turning), closed, false});
  }
  out.insert(out.end(), beside.begin(), beside.end());
  for (const TrackPiece& piece : pieces) out.push_back({axle_path(piece, turning), false, true});
  return out;
}

}  // namespace tramline
