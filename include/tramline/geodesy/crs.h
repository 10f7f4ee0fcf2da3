#pragma once
// A coordinate reference system of the input, with conversions to WGS 84 and back.
//
// Everywhere in tramline coordinates are in traditional GIS order: longitude, latitude; easting, northing.

#include <memory>
#include <optional>
#include <string>

#include "tramline/geometry/point.h"

namespace tramline {

/// The parameters of a transverse Mercator CRS that admission needs.
struct TransverseMercatorGrid {
  double false_easting_m = 0;
  double central_meridian_deg = 0;
};

/// An input CRS, or none at all (plain metres). Owns a PROJ context: objects may be used on different
/// threads, one object on one thread at a time.
class Crs {
 public:
  /// Plain metres: no CRS.
  Crs();
  /// WKT, "EPSG:25832", a PROJ string, a full name ("ETRS89 / UTM zone 32N"). Empty or "none": plain metres.
  /// Throws bad_input when PROJ does not know it or when it is not a geographic or projected CRS.
  explicit Crs(const std::string& definition);
  Crs(const Crs&) = delete;
  Crs& operator=(const Crs&) = delete;
  Crs(Crs&&) noexcept;
  Crs& operator=(Crs&&) noexcept;
  ~Crs();

  bool plain() const { return impl_ == nullptr; }
  /// "ETRS89 / UTM zone 32N (EPSG:25832)"; "plain metres" without a CRS.
  const std::string& name() const { return name_; }
  /// A definition from which an equal Crs can be made, on other machines too: "EPSG:25832" where the CRS has
  /// a code, else WKT2 on one line; "none" for plain metres. Heights and datum shifts that came with the
  /// definition are left out.
  const std::string& definition() const { return definition_; }
  /// Whether coordinates are longitude and latitude in degrees.
  bool in_degrees() const { return in_degrees_; }
  /// Set for transverse Mercator grids in metres.
  const std::optional<TransverseMercatorGrid>& grid() const { return grid_; }

  /// Whether a position is within two UTM zones of the CRS's area of use; true where PROJ knows of no such
  /// area. Far outside the area a projection still yields numbers.
  bool is_near(Point lonlat_deg) const;

  /// Longitude and latitude on WGS 84, degrees; nullopt where PROJ refuses the point (or a coordinate is
  /// not finite). Precondition: !plain().
  std::optional<Point> to_lonlat(Point input) const;
  /// The inverse of to_lonlat, to 1e-6 m within the CRS's area of use. Precondition: !plain().
  std::optional<Point> from_lonlat(Point lonlat_deg) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::string name_ = "plain metres";
  std::string definition_ = "none";
  bool in_degrees_ = false;
  std::optional<TransverseMercatorGrid> grid_;
};

}  // namespace tramline
