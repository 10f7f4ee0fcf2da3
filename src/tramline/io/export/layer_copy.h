#pragma once
// Copies one layer of a plan file into an export.

#include <ogrsf_frmts.h>

#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tramline/io/export/export_format.h"
#include "tramline/io/export/target_crs.h"
#include "tramline/model/local_frame.h"
#include "tramline/model/report.h"

namespace tramline::io {

/// The settings common to all layers of an export.
struct LayerWay {
  ExportFormat format;
  const TargetCrs& target;
  Point offset;            ///< offset_of() the field's frame
  std::time_t time;        ///< time stamp of the file
  double tolerance_m = 0;  ///< by which shapes may deviate from the plan's to need fewer vertices
  /// The fields' own frames by their keys, "" in a file of one plan: exact paths are written beside the
  /// chords where the format takes texts of any length. Empty: they are not.
  std::map<std::string, LocalFrame, std::less<>> frames{};
  int decimals = 10;  ///< of a degree in GeoJSON; 10 are 0.01 mm, the driver's own 7 a centimetre
};

/// Copies the features in their order, as described at export_plan(), and returns their number. Texts that
/// the format cannot hold whole are added to `shortened`. Failures of GDAL are left to the GdalErrors of the
/// caller; throws Error(kBadInput) where a shape has no position in the target CRS. O(n) in vertices.
int copy_layer(OGRLayer& from, GDALDataset& to, const LayerWay& way, std::vector<Skipped>& shortened);

/// The same for tracks and headland passes in one layer, named as that of the tracks: first the tracks, then
/// the passes, whose `kind` is kHeadlandKind. Returns the number of each.
std::pair<int, int> copy_lines(OGRLayer& tracks, OGRLayer& passes, GDALDataset& to, const LayerWay& way,
                               std::vector<Skipped>& shortened);

}  // namespace tramline::io
