#pragma once
// A reference line extended until it divides a box in two (S2.11).

#include "tramline/geometry/path/path.h"

namespace tramline {

struct Extended {
  Path path;
  bool blocked_at_start = false;  ///< it would have crossed the path: ends there
  bool blocked_at_end = false;    ///< it would have crossed the path, or what extends its start
};

/// The path with straight ends along its end tangents, each as long as it takes until the whole box lies
/// behind: no point of the box is then nearest to an end. An extension ends where it would meet the
/// path, or the other extension. Precondition: at least one segment. O(n).
Extended extended(const Path& path, const Box& box);

/// By a length at each end, m.
Extended extended(const Path& path, double at_start_m, double at_end_m);

}  // namespace tramline
