#pragma once
// The coordinate reference system of an export, and the way to it from the field's local metres.

#include <ogr_spatialref.h>

#include <optional>
#include <string>

#include "tramline/geodesy/field_projection.h"
#include "tramline/io/export/export_format.h"
#include "tramline/model/field.h"

namespace tramline::io {

/// Goes from the field's local metres to the exported coordinates and back. Holds PROJ objects: neither
/// copied nor moved, one thread at a time.
class TargetCrs {
 public:
  /// `asked`: "" for what the format does by itself, "source", "wgs84", or anything that Crs takes.
  /// Throws Error(kBadInput) where PROJ does not know it, where the format allows only WGS 84 and it is
  /// another, where the plan does not say its source, and where a field in plain metres is to be put
  /// somewhere on earth.
  TargetCrs(const Field& field, const std::string& asked, ExportFormat format);
  TargetCrs(const TargetCrs&) = delete;
  TargetCrs& operator=(const TargetCrs&) = delete;

  /// "ETRS89 / UTM zone 32N (EPSG:25832)", "plain metres"
  const std::string& name() const { return crs_.name(); }
  /// For the file.
  const OGRSpatialReference& reference() const { return reference_; }
  bool in_degrees() const { return crs_.in_degrees(); }
  /// The field's plane itself, shifted: straight lines stay straight.
  bool plain() const { return crs_.plain(); }

  /// Throws Error(kBadInput) where the CRS has no such place, or one that it does not lead back from.
  Point from_local(Point local_m) const;
  /// The inverse; nullopt where PROJ refuses the point.
  std::optional<Point> to_local(Point target) const;

 private:
  Crs crs_;
  FieldProjection projection_;
  OGRSpatialReference reference_;
};

}  // namespace tramline::io
