#pragma once
// A reference line extended until it divides a box into two parts (Zhou §2.3.4).

#include "tramline/geometry/path/path.h"

namespace tramline {

struct Extended {
  Path path;
  bool blocked_at_start = false;  ///< ends where it would have crossed the path
  bool blocked_at_end = false;    ///< ends where it would have crossed the path or its extended start
};

/// The path with straight extensions along its end tangents, each as long as it takes to leave the whole box
/// behind: no point of the box is then nearest to an end. An extension ends where it would meet the path or
/// the other extension. Precondition: at least one segment. O(n).
Extended extended(const Path& path, const Box& box);

/// The path extended by a length at each end, m.
Extended extended(const Path& path, double at_start_m, double at_end_m);

}  // namespace tramline
