#pragma once
// Land and lines that the user drew, in a field's local metres.

#include <vector>

#include "tramline/admission/given/read_subfields.h"
#include "tramline/model/plan.h"

namespace tramline {

/// Adds the subfields, cuts and land to leave out that meet the field to `given`, polygons cut to the field's
/// outer ring. Where polygons overlap the first keeps the land, and a remark says so. `used` (one flag per
/// feature) is set for those that meet the field; guides count as used with their subfields. Throws bad_input
/// for a guide without length. O(features) box tests, and O(n log n) per feature used.
void place_subfields(const Field& field, const std::vector<LooseSubfield>& subfields, std::vector<char>& used,
                     GivenLand& given);

/// The polygons of the features within the field's outer ring, united. Flags as above.
Region placed_land(const Field& field, const std::vector<LooseObstacle>& features, std::vector<char>& used);

}  // namespace tramline
