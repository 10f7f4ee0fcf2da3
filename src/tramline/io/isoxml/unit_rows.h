#pragma once
// Row units: each works the land up to half way to the next row.

#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// Widens the places of row units that stand apart, such as the rows of a planter, until they meet half way;
/// the outermost reach half a row beyond themselves. A row left out stays a gap: rows further apart than one
/// and a half times the usual distance (median), or than 2 m, do not meet. Places never become narrower.
/// O(n log n).
void reach_to_next_row(std::vector<Section*>& rows);

}  // namespace tramline::io
