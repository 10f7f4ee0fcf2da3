#pragma once
// What a tree over near joins lacks to be the least of all trees.

#include <vector>

#include "tramline/route/certificate/node_join.h"

namespace tramline::order {

/// All joins that cost less under prices than the most expensive one on the way between their members in the
/// tree, of each two members the cheapest: the least spanning tree of these and those of the tree is the
/// least of all (any other join is the most expensive one of a ring). least() decides which need not be
/// computed. O(n²) calls of that, O(n) memory besides the answer.
std::vector<NodeJoin> shortcuts(const JoinTree& tree, const std::vector<double>& prices_s,
                                const ConnectionBounds& bounds);

}  // namespace tramline::order
