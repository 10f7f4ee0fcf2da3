#pragma once
// Counts the self-crossings of a ring.

#include <cstddef>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The number of pairs of edges, not neighbours, that cross in a point inside both; counting ends with the
/// first above `most`. O(n log n + pairs of edges whose boxes overlap across).
std::size_t ring_crossings(const Ring& ring, std::size_t most);

}  // namespace tramline
