#include "tramline/headland/edges/chain_wall.h"

#include <algorithm>

#include "tramline/headland/tolerances.h"
#include "tramline/headland/wide_corners.h"

namespace tramline {
namespace {

/// Thickness of the wall, m: more than distances are distinguished by, less than matters.
constexpr double kWall_m = 1e-5;
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

/// Whether the arc is about a corner of the chain's own side, between its ends.
bool about_chain(const OffsetPiece& arc, const EdgeChain& chain) {
  return std::find(chain.begin() + 1, chain.end() - 1, arc.centre) != chain.end() - 1;
}

/// The arcs of the offset line that passes are driven along: not those behind the wall and about its ends.
std::vector<OffsetRing> arcs_to_drive(std::vector<OffsetRing> rings, const EdgeChain& chain) {
  for (OffsetRing& ring : rings)
    std::erase_if(ring, [&](const OffsetPiece& piece) {
      return !piece.segment.straight() && piece.offset_boundary == 0 && !about_chain(piece, chain);
    });
  return rings;
}

/// The indices of the chain's vertices between its ends.
std::vector<std::size_t> between_ends(const EdgeChain& chain) {
  std::vector<std::size_t> out;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) out.push_back(i);
  return out;
}

/// Whether the piece lies on the chain's own side of the wall: along one of its edges, about a corner between
/// its ends, about a disc, or along another boundary.
bool beside_chain(const OffsetPiece& piece, const EdgeChain& chain, const OffsetBoundary& wall) {
  if (piece.offset_boundary != 0) return true;
  if (!piece.segment.straight())
    return about_chain(piece, chain) ||
           std::find(wall.ring.begin(), wall.ring.end(), piece.centre) == wall.ring.end();
  const double distance_m = wall.distance_m;
  const Point middle = midpoint(piece.segment.from, piece.segment.to);
  const Point foot = middle + distance_m * right_of(piece.from_heading);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    if (dot(chain[i + 1] - chain[i], piece.from_heading) > 0 &&
        distance_to_segment(foot, chain[i], chain[i + 1]) < kWall_m)
      return true;
  return false;
}

}  // namespace

std::vector<OffsetRun> offset_runs(const TurningRoom& room, const EdgeChain& chain) {
  const OffsetBoundary& wall = room.offset_boundaries.front();
  std::vector<OffsetRun> out;
  for (const OffsetRing& ring : offset_lines(room)) {
    std::vector<char> beside;
    for (const OffsetPiece& piece : ring) beside.push_back(beside_chain(piece, chain, wall) ? 1 : 0);
    const auto behind = std::find(beside.begin(), beside.end(), 0);
    if (behind == beside.end()) {
      out.push_back({ring, true});
      continue;
    }
    const auto start = static_cast<std::size_t>(behind - beside.begin());
    bool open = false;
    for (std::size_t k = start; k < start + ring.size(); ++k) {
      const std::size_t i = k % ring.size();
      if (beside[i] != 0) {
        if (!open) out.emplace_back();
        out.back().pieces.push_back(ring[i]);
      }
      open = beside[i] != 0;
    }
  }
  std::erase_if(out, [](const OffsetRun& run) {
    return std::none_of(run.pieces.begin(), run.pieces.end(),
                        [](const OffsetPiece& piece) { return piece.offset_boundary == 0; });
  });
  return out;
}

TurningRoom room_beside(const EdgeChain& chain, const std::vector<Boundary>& obstacles, double width_m,
                        int number, double radius_m) {
  TurningRoom out;
  out.radius_m = radius_m;
  const double beside_m = (number - 0.5) * width_m - kJustFits_m;
  out.offset_boundaries.push_back({wall_along(chain), beside_m});
  bool any_tight = beside_m < radius_m;
  for (const Boundary& obstacle : obstacles) {
    const double distance_m = pass_distance_m(obstacle, number, width_m) - kJustFits_m;
    out.offset_boundaries.push_back({obstacle.ring, distance_m});
    any_tight = any_tight || distance_m < radius_m;
  }
  if (any_tight) {
    const std::vector<OffsetRing> rings = offset_rings(out.offset_boundaries);
    out.discs = wide_corners(arcs_to_drive(rings, chain), rings, radius_m);
  }
  if (beside_m < radius_m) out.offset_boundaries.front().covered_corners = between_ends(chain);
  for (std::size_t i = 1; i < out.offset_boundaries.size(); ++i)
    out.offset_boundaries[i].round_corners = out.offset_boundaries[i].distance_m >= radius_m;
  return out;
}

}  // namespace tramline
