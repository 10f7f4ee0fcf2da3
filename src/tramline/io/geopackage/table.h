#pragma once
// Layers of a GeoPackage under construction: shapes in the file's coordinates, attributes as cells.

#include <ogrsf_frmts.h>

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/io/geopackage/field_names.h"

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

/// A number, or NULL where there is none.
Cell number_if(const std::optional<double>& number);
/// A number, or NULL for NaN.
Cell number_unless_nan(double number);

/// Local metres to the file's coordinates: the offset is added, or the point projected. Zeros have no sign.
class Shapes {
 public:
  explicit Shapes(Point offset) : offset_(offset) {}
  explicit Shapes(std::function<Point(Point)> project) : project_(std::move(project)) {}

  std::unique_ptr<OGRGeometry> point(Point p) const;
  std::unique_ptr<OGRGeometry> line(const std::vector<Point>& points) const;
  std::unique_ptr<OGRGeometry> polygon(const Polygon& polygon) const;
  /// A multipolygon.
  std::unique_ptr<OGRGeometry> region(const Region& region) const;

 private:
  void append(OGRLineString& out, const std::vector<Point>& points, bool closed) const;
  Point placed(Point p) const;
  Point offset_{};
  std::function<Point(Point)> project_;
};

struct Target;

/// Failures are left to the GdalErrors of the caller.
class Table {
 public:
  /// `crs` is nullptr for a table without shapes.
  Table(GDALDataset& file, const char* name, OGRwkbGeometryType type, OGRSpatialReference* crs,
        std::initializer_list<Column> columns, const char* key = "fid");
  /// In a file of several fields an existing layer is extended, and every row has the names of its field.
  Table(const Target& target, const char* name, OGRwkbGeometryType type,
        std::initializer_list<Column> columns);

  /// Adds a row with as many cells as columns.
  void add(std::unique_ptr<OGRGeometry> shape, std::initializer_list<Cell> cells);

 private:
  void add_columns(std::initializer_list<Column> columns);

  OGRLayer* layer_;
  const FieldNames* names_ = nullptr;  ///< nullptr: the file is of one field
};

/// The destination of the layers of one file.
struct Target {
  GDALDataset& file;
  OGRSpatialReference* crs;
  Point offset;  ///< offset to add to local metres in texts
  Shapes shapes;
  /// Of the field whose rows are written; nullptr: the file is of one field.
  const FieldNames* names = nullptr;
};

}  // namespace tramline::io
