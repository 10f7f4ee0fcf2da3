#pragma once
// Layers of a GeoPackage under construction: shapes in the file's coordinates, attributes as cells.

#include <ogrsf_frmts.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "tramline/geometry/region.h"

namespace tramline::io {

struct Column {
  const char* name;
  OGRFieldType type;
  OGRFieldSubType subtype = OFSTNone;
};
constexpr Column integer(const char* name) { return {name, OFTInteger}; }
constexpr Column count_of(const char* name) { return {name, OFTInteger64}; }
constexpr Column real(const char* name) { return {name, OFTReal}; }
constexpr Column text(const char* name) { return {name, OFTString}; }
constexpr Column flag(const char* name) { return {name, OFTInteger, OFSTBoolean}; }
inline constexpr Column kAreaColumn{"area_m2", OFTReal};

using Cell = std::variant<std::monostate, long long, double, bool, std::string>;  // monostate: NULL

/// A number, or NULL.
Cell number_if(bool any, double number);
/// A number, or NULL where it is none.
Cell number_unless_nan(double number);

/// Local metres to the file's coordinates: the offset is added. Zeros have no sign.
class Shapes {
 public:
  explicit Shapes(Point offset) : offset_(offset) {}

  std::unique_ptr<OGRGeometry> point(Point p) const;
  std::unique_ptr<OGRGeometry> line(const std::vector<Point>& points) const;
  std::unique_ptr<OGRGeometry> polygon(const Polygon& polygon) const;
  /// A multipolygon.
  std::unique_ptr<OGRGeometry> region(const Region& region) const;

 private:
  void append(OGRLineString& out, const std::vector<Point>& points, bool closed) const;
  Point offset_;
};

/// Failures are left to the GdalErrors of the caller.
class Table {
 public:
  /// `crs` is nullptr for a table without shapes.
  Table(GDALDataset& file, const char* name, OGRwkbGeometryType type, OGRSpatialReference* crs,
        std::initializer_list<Column> columns, const char* key = "fid");

  /// As many cells as columns.
  void add(std::unique_ptr<OGRGeometry> shape, std::initializer_list<Cell> cells);

 private:
  OGRLayer* layer_;
};

/// Where the layers of one file go.
struct Target {
  GDALDataset& file;
  OGRSpatialReference* crs;
  Point offset;
  Shapes shapes;
};

}  // namespace tramline::io
