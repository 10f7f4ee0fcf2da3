#pragma once
// Passes along some edges of the field.

#include <vector>

#include "tramline/headland/edges/chain_ground.h"
#include "tramline/headland/headland.h"
#include "tramline/headland/pass_boundaries.h"
#include "tramline/headland/worth/worth_driving.h"

namespace tramline {

/// A chain of edges with the same number of passes or more, and the land that so many passes work.
struct ChainToFollow {
  EdgeChain chain;
  ChainGround ground;
};

/// Pass `number` along the chain: (number − ½)·w from it, round corners and obstacles as passes round
/// the whole field (rolling_circle_paths()), without regard to other edges of the field. Each path goes
/// straight on at its ends until its swath reaches the boundary, an obstacle, or the swath of one of the
/// passes `before`; at a flat end of the chain it stops. Parts that are not worth driving on the chain's
/// ground are left out, unless what they work in vain costs less than an interruption. Open paths, with the
/// edges on their right. O(n²) for n corners.
std::vector<HeadlandPass> passes_along(const ChainToFollow& chain, const std::vector<Boundary>& boundaries,
                                       const HeadlandTerms& terms, int number, const Region& passable,
                                       const std::vector<HeadlandPass>& before);

}  // namespace tramline
