#pragma once
// Row units: each works the land up to half way to the next row.

#include <vector>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// Widens the sections of row units that are apart, such as the rows of a planter, until they meet half way;
/// the outermost extend half a row outwards. A missing row stays a gap: rows further apart than one and a
/// half times the usual distance (median), or than 2 m, do not meet. Sections never become narrower. O(n log
/// n).
void reach_to_next_row(std::vector<Section*>& rows);

}  // namespace tramline::io
