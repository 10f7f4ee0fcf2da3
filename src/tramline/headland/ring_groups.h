#pragma once
// Closed passes round boundaries, and which boundaries are driven round together.

#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/headland/pass_boundaries.h"
#include "tramline/headland/worth/worth_driving.h"

namespace tramline {

/// Radius of the tightest circle that passes are driven on, m: the machine's, or the least that does not fold
/// its swath.
double tightest_turn_m(const HeadlandTerms& terms);

/// Boundaries that are driven round together, and the passes round them.
struct RingGroup {
  std::vector<std::size_t> members;  ///< indices into the boundaries, increasing
  std::vector<HeadlandPass> passes;  ///< closed
};

/// Pass `number` round some of the boundaries, as if there were no others. Rings that follow no boundary with
/// such a pass are left out.
std::vector<HeadlandPass> rings_round(const std::vector<std::size_t>& members,
                                      const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                      int number, const GroundToWork& to_work,
                                      const std::vector<HeadlandPass>& before);

/// All boundaries in groups: each by itself, or with those whose swaths with this number, or the land these
/// have to keep off, its own swath would meet. A field without such a pass is never driven round with its
/// obstacles: their passes may come too near to it, or leave it.
std::vector<RingGroup> ring_groups(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                   int number, const GroundToWork& to_work,
                                   const std::vector<HeadlandPass>& before);

}  // namespace tramline
