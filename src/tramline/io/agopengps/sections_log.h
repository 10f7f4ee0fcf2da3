#pragma once
// Coverage that AgOpenGPS has recorded (Sections.txt), as a log.

#include "tramline/io/agopengps/field_folder.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The land that each section worked from one record to the next, as shapes of WGS 84 (WorkLog::shapes),
/// patch by patch in the order of the file; times are not recorded. Each patch is a strip of left and right
/// ends, after a line with its colour. Throws bad_input, naming file and line, where there is no
/// Sections.txt, it cannot be read, or nothing in it was worked. O(size).
WorkLog sections_log(const FieldFolder& folder);

}  // namespace tramline::io
