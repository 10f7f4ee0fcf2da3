#pragma once
// As-applied polygons: ground that a file says was worked.

#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/io/log/fix_rows.h"
#include "tramline/model/raw_feature.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The polygons of a feature with three finite corners or more each; a polygon with a corner that is no place
/// is left out. Frame: the file's.
std::vector<Polygon> worked_shapes(const RawFeature& feature);

/// What holds for a log of polygons once all are read: where rates are recorded and nothing else says what
/// worked, a rate of 0 worked nothing. Throws bad_input where no column tells of time, work, width or rate:
/// such polygons are fields rather than work.
void finish_shapes(WorkLog& log, const FixRows& rows, const std::string& place);

}  // namespace tramline::io
