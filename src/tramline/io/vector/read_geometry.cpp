#include "tramline/io/vector/read_geometry.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/flatten_geometry.h"
#include "tramline/io/vector/gdal_drivers.h"
#include "tramline/io/vector/gdal_messages.h"

namespace tramline::io {
namespace {

/// nullptr where the bytes are none.
OGRGeometry* geometry_of(const std::string& bytes, GeometryForm form) {
  OGRGeometry* out = nullptr;
  switch (form) {
    case GeometryForm::kWkb:
      OGRGeometryFactory::createFromWkb(bytes.data(), nullptr, &out, bytes.size());
      break;
    case GeometryForm::kWkt:
      OGRGeometryFactory::createFromWkt(bytes.c_str(), nullptr, &out);
      break;
    case GeometryForm::kGeoJson:
      out = OGRGeometryFactory::createFromGeoJson(bytes.c_str());
      break;
  }
  return out;
}

const char* name(GeometryForm form) {
  if (form == GeometryForm::kWkb) return "well-known binary (WKB)";
  return form == GeometryForm::kWkt ? "well-known text (WKT)" : "a geometry of GeoJSON";
}

}  // namespace

RawFeature read_geometry(const std::string& bytes, GeometryForm form) {
  register_gdal_drivers();
  const GdalMessages messages;
  const std::unique_ptr<OGRGeometry> geometry(geometry_of(bytes, form));
  if (geometry == nullptr)
    throw bad_input(fmt::format("the field is not {}{}", name(form),
                                messages.failed() ? fmt::format(": {}", messages.last()) : ""));
  RawFeature out;
  flatten_geometry(geometry.get(), AxisOrder::kXFirst, out);
  return out;
}

}  // namespace tramline::io
