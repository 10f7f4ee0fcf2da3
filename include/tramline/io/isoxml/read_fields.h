#pragma once
// Reads fields from vector files and from task sets alike.

#include "tramline/io/vector/read_vector.h"
#include "tramline/model/raw_feature.h"

namespace tramline::io {

/// As read_vector(); the file may also be an ISOXML task set (folder, TASKDATA.XML or zip), whose layers are
/// "partfields" (read when none is named) and "obstacles". Its only filter is id = 'PFD1'. Throws bad_input
/// like read_vector() and read_partfields().
RawDataset read_fields(const VectorQuery& query);

}  // namespace tramline::io
