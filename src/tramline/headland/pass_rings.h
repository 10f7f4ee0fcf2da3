#pragma once
// The rings of one pass, drivable.

#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/headland/shores.h"

namespace tramline {

/// What headlands are there to work, and what is worked already.
struct Worked {
  const Region& ground;
  const std::vector<HeadlandPass>& passes;
};

/// Pass `number` round all boundaries that have so many. Boundaries are driven round one by one; where the
/// swaths would meet those of another boundary, or what they have to keep off, the two are driven round
/// together. Necks are driven through where that leaves more of the ground worked than worked twice.
std::vector<HeadlandPass> pass_rings(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                     int number, const Worked& before);

}  // namespace tramline
