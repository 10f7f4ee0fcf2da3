#pragma once
// The coordinate reference system of an export, with conversion from the field's local metres.

#include <ogr_spatialref.h>

#include <optional>
#include <string>

#include "tramline/geodesy/field_projection.h"
#include "tramline/io/export/export_format.h"
#include "tramline/model/field.h"

namespace tramline::io {

/// Converts the field's local metres to the exported coordinates and back. Holds PROJ objects: neither copied
/// nor moved, one thread at a time.
class TargetCrs {
 public:
  /// `asked`: "" for the format's default, "source", "wgs84", or any definition accepted by Crs. Throws
  /// Error(kBadInput) where PROJ does not know it, where the format allows only WGS 84 and another is asked
  /// for, where the plan does not record its source CRS, and where a field in plain metres is to be
  /// georeferenced.
  TargetCrs(const Field& field, const std::string& asked, ExportFormat format);
  TargetCrs(const TargetCrs&) = delete;
  TargetCrs& operator=(const TargetCrs&) = delete;

  /// "ETRS89 / UTM zone 32N (EPSG:25832)", "plain metres"
  const std::string& name() const { return crs_.name(); }
  /// The definition for the file.
  const OGRSpatialReference& reference() const { return reference_; }
  bool in_degrees() const { return crs_.in_degrees(); }
  /// Whether it is the field's plane itself, shifted, so that straight lines stay straight.
  bool plain() const { return crs_.plain(); }

  /// Throws Error(kBadInput) where the point has no position in the CRS, or one that cannot be converted
  /// back.
  Point from_local(Point local_m) const;
  /// The inverse; nullopt where PROJ refuses the point.
  std::optional<Point> to_local(Point target) const;

 private:
  Crs crs_;
  FieldProjection projection_;
  OGRSpatialReference reference_;
};

}  // namespace tramline::io
