#pragma once
// What no route can take less than: the bound of Held and Karp (1970) over the ends of lines.

#include <cstddef>
#include <vector>

#include "tramline/route/certificate/connection_bounds.h"

namespace tramline::order {

/// The least time of all connections of a route together, as the prices of the nodes prove it: the least
/// spanning tree over lines, gates and rings, where joining two costs the least of the times between their
/// nodes plus the prices of these nodes, less the prices of all connections, plus the smallest prices of as
/// many nodes of lines and rings as the route has ends without a gate (there it makes one connection less). A
/// bound for any prices. O(n²) calls of between(), none of least(). Precondition: a price for each node.
double bound_of(const std::vector<double>& prices_s, const ConnectionBounds& bounds);

/// The same number but for rounding, with far fewer calls of between(). O(n²) calls of least(), O(n) memory.
double bound_of_pruned(const std::vector<double>& prices_s, const ConnectionBounds& bounds);

/// The nodes of lines and rings with the smallest prices, as many as a route has ends without a gate; among
/// equals the first. A ring alone counts twice. Precondition: a line or a ring, at most two gates.
std::vector<std::size_t> open_nodes(const std::vector<double>& prices_s, const ConnectionBounds& bounds);

/// The bound, given the sum of the least spanning tree.
double bound_with(double tree_s, const std::vector<double>& prices_s, const ConnectionBounds& bounds);

}  // namespace tramline::order
