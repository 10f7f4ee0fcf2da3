#pragma once
// As-applied polygons: land recorded as worked.

#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/io/log/fix_rows.h"
#include "tramline/model/raw_feature.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The polygons of a feature with three or more corners each; a polygon with a corner that is not finite is
/// left out. Frame: the file's.
std::vector<Polygon> worked_shapes(const RawFeature& feature);

/// Completes a log of polygons once all are read: where rates are recorded but no work states, a rate of 0
/// means no work. Throws bad_input where there is no column for time, work, width or rate: such polygons are
/// fields rather than work.
void finish_shapes(WorkLog& log, const FixRows& rows, const std::string& place);

}  // namespace tramline::io
