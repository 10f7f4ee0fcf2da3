#pragma once
// One division of a field on other ground of the same field.

#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline {

/// The parts of the ground with the lines of the subfield that each lies in. Ground beyond the subfields,
/// where there are fewer headland passes, is divided by their seams, driven on straight, and belongs to the
/// subfields it adjoins. Where all subfields have one direction the ground is not divided. Precondition:
/// there is a subfield. O(the booleans, and c² for c corners).
std::vector<Subfield> divided_like(const Region& ground, const std::vector<Subfield>& layout);

}  // namespace tramline
