#pragma once
// A field of the kind Versleijen reports times for, made for measuring.

#include "tramline/model/field.h"

namespace tramline::bench {

/// 8 ha, two obstacles of 7 × 7 m and 69 distinct edge directions: Versleijen table 9 has 84.34 s for its
/// field 1739 of that kind (7.9 ha, 2 obstacles, 69 directions).
Field papers_field();

/// A smooth outline of `vertices` corners and `obstacles` squares: about 60 ha.
Field large_field(int vertices, int obstacles);

}  // namespace tramline::bench
