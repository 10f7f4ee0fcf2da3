#pragma once
// Reads fields, and lines to drive along, from vector files, task sets and field folders of AgOpenGPS alike.

#include "tramline/io/vector/read_vector.h"
#include "tramline/model/raw_feature.h"

namespace tramline::io {

/// As read_vector(); the file may also be an ISOXML task set (folder, TASKDATA.XML or zip), whose layers are
/// "partfields" (read when none is named) and "obstacles", or a field folder of AgOpenGPS, with the layer
/// "fields". Their only filters are id = 'PFD1' and, of task sets, designator = 'Mill' and code = '7'. Throws
/// bad_input like read_vector() and read_partfields().
RawDataset read_fields(const VectorQuery& query);

/// The lines of a vector file, as read_vector(); of a task set the guidance lines, and of a field folder of
/// AgOpenGPS its tracks and headland lines. The filter of the latter two is id = 'GPN1' or name = 'AB 1'.
/// Where several lines have that name the query has all of them. Throws bad_input like read_vector() and
/// read_guidance().
RawDataset read_guides(const VectorQuery& query);

}  // namespace tramline::io
