#include "tramline/io/vector/layer_crs.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "tramline/geometry/error.h"

namespace tramline::io {

std::string layer_crs(const OGRSpatialReference* srs, const std::string& place) {
  if (srs == nullptr || srs->IsEmpty()) return {};
  const char* name = srs->GetName();
  if (name != nullptr && std::string(name).rfind("Undefined", 0) == 0) return {};
  if (srs->IsLocal()) {
    if (srs->GetLinearUnits() == 1.0) return {};
    throw bad_input(
        fmt::format("{} is in a local grid with units other than metres; convert it to metres", place));
  }
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
  const OGRErr status = srs->exportToWkt(&text, options);
  std::string out = status == OGRERR_NONE && text != nullptr ? text : "";
  CPLFree(text);
  return out;
}

AxisOrder axis_order(const OGRSpatialReference* srs) {
  if (srs == nullptr) return AxisOrder::kXFirst;
  OGRSpatialReference traditional(*srs);
  traditional.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const bool as_traditional = srs->GetDataAxisToSRSAxisMapping() == traditional.GetDataAxisToSRSAxisMapping();
  return as_traditional ? AxisOrder::kXFirst : AxisOrder::kYFirst;
}

}  // namespace tramline::io
