#pragma once
// One layer of a plan file copied into an export.

#include <ogrsf_frmts.h>

#include <ctime>
#include <vector>

#include "tramline/io/export/export_format.h"
#include "tramline/io/export/target_crs.h"
#include "tramline/model/report.h"

namespace tramline::io {

/// What all layers of an export have in common.
struct LayerWay {
  ExportFormat format;
  const TargetCrs& target;
  Point offset;            ///< offset_of() the field's frame
  std::time_t time;        ///< of the file
  double tolerance_m = 0;  ///< by which shapes may deviate from the plan's to need fewer vertices
};

/// Copies the features in their order, as export_plan() says, and gives their number. Texts that the format
/// cannot hold whole are added to `shortened`. Failures of GDAL are left to the GdalErrors of the caller;
/// throws Error(kBadInput) where the target has no place for a shape. O(n) in vertices.
int copy_layer(OGRLayer& from, GDALDataset& to, const LayerWay& way, std::vector<Skipped>& shortened);

}  // namespace tramline::io
