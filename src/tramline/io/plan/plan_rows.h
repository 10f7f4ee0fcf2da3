#pragma once
// Writes the layers and tables of one plan into a file of one plan or of many.

#include "tramline/io/geopackage/metadata.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// Writes everything except the styles. Failures of GDAL are left to the GdalErrors of the caller.
void write_plan_rows(const Target& target, const Plan& plan, const Metadata& remarks);

}  // namespace tramline::io
