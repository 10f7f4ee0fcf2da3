#pragma once
// Points of vector files as a log.

#include <string>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// The point features of a layer with their attributes as columns (see columns.h). `layer`: which one; empty:
/// the only one with points. Fixes come in the order of the file, or by their times where those are not in
/// order. `crs` replaces the layer's. Fix::record counts features from 1. Throws bad_input for a file that
/// GDAL cannot read, for a layer that is not there, for several with points and no choice, and when no
/// feature has a possible position. O(size).
WorkLog read_vector_log(const std::string& path, const std::string& layer, const std::string& columns,
                        const std::string& crs);

}  // namespace tramline::io
