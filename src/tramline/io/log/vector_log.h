#pragma once
// Reads points or worked land of vector files as a log.

#include <string>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// The features of a layer with their attributes as columns (see columns.h): points, or polygons, which are
/// worked land (WorkLog::shapes). The first feature decides between the two; features of the other kind are
/// skipped. Polygons without a column for time, work, width or rate are not a log. `layer`: the layer to
/// read; empty: the only one with points, or where there is none, the only one with polygons. Features come
/// in the order of the file, or by their times where those are not in order. `crs` replaces the layer's.
/// Fix::record counts features from 1. Throws bad_input for a file that GDAL cannot read, for a missing
/// layer, for several layers without a choice, and when no feature has a possible position. O(size).
WorkLog read_vector_log(const std::string& path, const std::string& layer, const std::string& columns,
                        const std::string& crs);

}  // namespace tramline::io
