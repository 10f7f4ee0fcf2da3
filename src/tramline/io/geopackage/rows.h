#pragma once
// GeoPackages as rows: features with their location for messages, shapes in local metres.

#include <ogrsf_frmts.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/io/geopackage/file_kind.h"
#include "tramline/io/geopackage/gdal_errors.h"

namespace tramline::io {

/// The conversion from coordinates of a file to local metres.
struct FileToLocal {
  Point offset;                              ///< subtracted last
  std::function<Point(Point)> project = {};  ///< where the file is not in the field's own plane
  Point operator()(Point p) const { return (project ? project(p) : p) - offset; }
};

/// One feature of a layer. Every function throws Error(kBadInput) naming file, layer, feature and
/// column where a value is missing, not finite or of the wrong type.
class Row {
 public:
  /// `to_local` and `kind` have to outlive this.
  Row(const OGRFeature& feature, std::string place, const FileToLocal& to_local, const FileKind& kind)
      : feature_(feature), place_(std::move(place)), to_local_(to_local), kind_(kind) {}

  /// "plan.gpkg: layer tracks, feature 2"
  const std::string& place() const { return place_; }
  /// The same and the column, for messages: "plan.gpkg: layer tracks, feature 2: path"
  std::string place_of(const char* column) const { return place_ + ": " + column; }

  bool has(const char* column) const { return feature_.GetFieldIndex(column) >= 0; }
  double number(const char* column) const;
  /// nullopt for NULL.
  std::optional<double> number_if_any(const char* column) const;
  int whole(const char* column) const { return feature_.GetFieldAsInteger(index(column)); }
  /// nullopt for NULL.
  std::optional<int> whole_if_any(const char* column) const;
  /// A number that is not negative.
  std::size_t count(const char* column) const;
  bool flag(const char* column) const { return whole(column) != 0; }
  std::string text(const char* column) const { return feature_.GetFieldAsString(index(column)); }

  bool has_shape() const;
  Polygon polygon() const;
  /// The polygons of a multipolygon.
  Region region() const;
  /// At least two points.
  std::vector<Point> line() const;
  std::pair<Point, Point> straight_line() const;
  Point point() const;
  /// The offset to subtract from coordinates in texts to get local metres.
  Point offset() const { return to_local_.offset; }

 private:
  bool is_null(const char* column) const;
  int index(const char* column) const;
  Point vertex(const OGRSimpleCurve& line, int i) const;
  Ring ring(const OGRLinearRing& closed) const;
  Polygon polygon(const OGRPolygon& source) const;
  Error wrong(const std::string& what) const;

  const OGRFeature& feature_;
  std::string place_;
  const FileToLocal& to_local_;
  const FileKind& kind_;
};

/// An attribute filter for the rows of the field of this key, in a file of several.
std::string filter_for(const std::string& field_key);

/// A GeoPackage open for reading. Throws Error(kBadInput) where the file is missing, truncated or not a
/// GeoPackage.
class Rows {
 public:
  /// `errors` and `kind` have to outlive this.
  Rows(const std::filesystem::path& path, const FileKind& kind, GdalErrors& errors);

  /// Sets the offset to subtract from all coordinates from now on.
  void shift_by(Point offset) { to_local_.offset = offset; }
  /// Sets the projection applied to the coordinates of all shapes before that.
  void project_by(std::function<Point(Point)> project) { to_local_.project = std::move(project); }
  /// Restricts rows from now on to the field of this key, in a file of several.
  void only(const std::string& key) { key_ = key; }

  bool has(const char* name) { return file_->GetLayerByName(name) != nullptr; }

  /// Passes every feature of a layer to `take`, in the order of the file.
  void each(const char* name, const std::function<void(const Row&)>& take);

 private:
  std::filesystem::path path_;
  const FileKind& kind_;
  GdalErrors& errors_;
  GDALDatasetUniquePtr file_;
  FileToLocal to_local_;
  std::optional<std::string> key_;
};

}  // namespace tramline::io
