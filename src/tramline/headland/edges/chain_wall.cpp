#include "tramline/headland/edges/chain_wall.h"

#include <algorithm>
#include <cmath>

#include "tramline/headland/tolerances.h"
#include "tramline/headland/wide_corners.h"

namespace tramline {
namespace {

/// Thickness of the wall, m: more than distances are distinguished by, less than matters.
constexpr double kWall_m = 1e-4;
static_assert(kSamePlace_m < kWall_m && kSameDistance_m < kWall_m);

/// There along the chain, and back on its other side.
Ring wall_along(const EdgeChain& chain) {
  const std::size_t last = chain.size() - 1;
  const auto outward = [&](std::size_t edge) {
    return (1 / distance(chain[edge], chain[edge + 1])) * right_of(chain[edge + 1] - chain[edge]);
  };
  Ring out = chain;
  for (std::size_t i = last + 1; i-- > 0;) {
    Point across = i < last ? outward(i) : outward(last - 1);
    if (i > 0 && i < last) across = across + outward(i - 1);
    const double length_m = length(across);
    if (length_m > kRounding_share) out.push_back(chain[i] + (kWall_m / length_m) * across);
  }
  return out;
}

/// Radius by which a disc about an end covers the corners of the wall there.
double covering_m(double distance_m) { return distance_m + 2 * kWall_m; }

/// The arcs of the offset line without those about the ends of the wall.
std::vector<OffsetRing> without_ends(std::vector<OffsetRing> rings, const EdgeChain& chain) {
  const auto at_end = [&](const OffsetPiece& piece) {
    return !piece.segment.straight() && piece.offset_boundary == 0 &&
           std::min(distance(piece.centre, chain.front()), distance(piece.centre, chain.back())) < 2 * kWall_m;
  };
  for (OffsetRing& ring : rings) std::erase_if(ring, at_end);
  return rings;
}

}  // namespace

RoomBeside room_beside(const EdgeChain& chain, const std::vector<Boundary>& obstacles, double width_m,
                       int number, double radius_m) {
  RoomBeside out;
  TurningRoom& room = out.room;
  room.radius_m = radius_m;
  const double beside_m = (number - 0.5) * width_m - kJustFits_m;
  room.offset_boundaries.push_back({wall_along(chain), beside_m});
  bool any_tight = beside_m < radius_m;
  for (const Boundary& obstacle : obstacles) {
    const double distance_m = pass_distance_m(obstacle, number, width_m) - kJustFits_m;
    room.offset_boundaries.push_back({obstacle.ring, distance_m});
    any_tight = any_tight || distance_m < radius_m;
  }
  if (any_tight)
    room.discs = wide_corners(without_ends(offset_rings(room.offset_boundaries), chain), radius_m);
  for (OffsetBoundary& offset_boundary : room.offset_boundaries)
    offset_boundary.round_corners = offset_boundary.distance_m >= radius_m;
  out.end_m = kWall_m;
  if (beside_m < radius_m) {
    const double cover_m = covering_m(beside_m);
    for (const Point end : {chain.front(), chain.back()}) room.discs.push_back({end, cover_m, 0});
    out.end_m += 1.5 * std::sqrt((cover_m - beside_m) * (cover_m + beside_m));
  }
  return out;
}

}  // namespace tramline
