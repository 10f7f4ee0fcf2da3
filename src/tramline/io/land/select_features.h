#pragma once
// Filters of task sets and of field folders, which no database engine reads.

#include "tramline/io/vector/read_vector.h"
#include "tramline/model/raw_feature.h"

namespace tramline::io {

/// Keeps the fields that the query asks for: id = 'PFD1', designator = 'Mill' or code = '7', a number, a
/// limit. `matching` becomes how many there are without the limit. Throws bad_input for other filters, and
/// where there is no feature of that number.
void select_features(RawLayer& layer, const VectorQuery& query);

/// Keeps the lines that the filter of the query asks for: name = 'AB 1' or id = 'GPN1'. Throws bad_input for
/// other filters, and naming all lines where there is none of that name or id.
void select_guides(RawLayer& layer, const VectorQuery& query);

}  // namespace tramline::io
