#include "tramline/io/geopackage/rows.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>

#include "tramline/geometry/error.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/field_names.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

Error no_geopackage(const fs::path& path, const FileKind& kind) {
  return bad_input(fmt::format("{}: this is not a GeoPackage; give a {} written by {}", path.string(),
                               kind.what, kind.writer));
}

/// SQLite's header holds the page size and the number of pages, so a file cut off shows at once;
/// SQLite itself would only notice when a lost page is asked for.
void require_whole(const fs::path& path, const FileKind& kind) {
  std::error_code error;
  if (!fs::exists(path, error)) throw bad_input(fmt::format("{}: there is no such file", path.string()));
  std::array<unsigned char, 32> header{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(header.data()), header.size());
  if (!stream || std::memcmp(header.data(), "SQLite format 3", 16) != 0) throw no_geopackage(path, kind);
  const std::uintmax_t page = header[16] * 256u + header[17];
  const std::uintmax_t page_bytes = page == 1 ? 65536 : page;
  const std::uintmax_t pages =
      (std::uintmax_t{header[28]} << 24) + (header[29] << 16) + (header[30] << 8) + header[31];
  if (fs::file_size(path, error) < page_bytes * pages)
    throw bad_input(fmt::format("{}: the file is cut off; write the {} again", path.string(), kind.what));
}

}  // namespace

double Row::number(const char* column) const {
  const double value = feature_.GetFieldAsDouble(index(column));
  if (!std::isfinite(value)) throw bad_input(fmt::format("{}: {} is not a finite number", place_, column));
  return value;
}

std::optional<double> Row::number_if_any(const char* column) const {
  if (is_null(column)) return std::nullopt;
  return number(column);
}

std::optional<int> Row::whole_if_any(const char* column) const {
  if (is_null(column)) return std::nullopt;
  return whole(column);
}

std::size_t Row::count(const char* column) const {
  const GIntBig value = feature_.GetFieldAsInteger64(index(column));
  if (value < 0) throw bad_input(fmt::format("{}: {} is negative", place_, column));
  return static_cast<std::size_t>(value);
}

bool Row::has_shape() const { return feature_.GetGeometryRef() != nullptr; }

Polygon Row::polygon() const {
  const OGRGeometry* shape = feature_.GetGeometryRef();
  if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbPolygon || shape->IsEmpty())
    throw wrong("has no polygon");
  return polygon(*shape->toPolygon());
}

Region Row::region() const {
  const OGRGeometry* shape = feature_.GetGeometryRef();
  if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbMultiPolygon)
    throw wrong("has no multipolygon");
  Region out;
  for (const OGRPolygon* part : *shape->toMultiPolygon()) {
    if (part->IsEmpty()) throw wrong("has a part without an outline");
    out.push_back(polygon(*part));
  }
  return out;
}

std::vector<Point> Row::line() const {
  const OGRGeometry* shape = feature_.GetGeometryRef();
  if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbLineString ||
      shape->toLineString()->getNumPoints() < 2)
    throw wrong("has no line of two points or more");
  std::vector<Point> out;
  for (int i = 0; i < shape->toLineString()->getNumPoints(); ++i)
    out.push_back(vertex(*shape->toLineString(), i));
  return out;
}

std::pair<Point, Point> Row::straight_line() const {
  const std::vector<Point> points = line();
  if (points.size() != 2) throw wrong("is no straight line of two points");
  return {points[0], points[1]};
}

Point Row::point() const {
  const OGRGeometry* shape = feature_.GetGeometryRef();
  if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbPoint || shape->IsEmpty())
    throw wrong("has no point");
  const Point p = to_local_({shape->toPoint()->getX(), shape->toPoint()->getY()});
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw wrong("has no finite coordinates");
  return p;
}

/// A column that is not there is no NULL: index() complains about it.
bool Row::is_null(const char* column) const {
  const int found = feature_.GetFieldIndex(column);
  return found >= 0 && !feature_.IsFieldSetAndNotNull(found);
}

int Row::index(const char* column) const {
  const int found = feature_.GetFieldIndex(column);
  if (found < 0 || !feature_.IsFieldSetAndNotNull(found))
    throw wrong(fmt::format("has no value for {}", column));
  return found;
}

Point Row::vertex(const OGRSimpleCurve& line, int i) const {
  const Point p = to_local_({line.getX(i), line.getY(i)});
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw bad_input(fmt::format("{}: vertex {} has no finite coordinates", place_, i));
  return p;
}

Ring Row::ring(const OGRLinearRing& closed) const {
  Ring out;
  for (int i = 0; i + 1 < closed.getNumPoints(); ++i) out.push_back(vertex(closed, i));
  if (out.size() < 3) throw bad_input(place_ + " has a ring of fewer than three vertices");
  return out;
}

Polygon Row::polygon(const OGRPolygon& source) const {
  Polygon out{ring(*source.getExteriorRing()), {}};
  for (int i = 0; i < source.getNumInteriorRings(); ++i)
    out.holes.push_back(ring(*source.getInteriorRing(i)));
  return out;
}

Error Row::wrong(const std::string& what) const {
  return bad_input(fmt::format("{} {}; write the {} again", place_, what, kind_.what));
}

std::string filter_for(const std::string& field_key) {
  const std::unique_ptr<char, decltype(&CPLFree)> quoted(
      CPLEscapeString(field_key.c_str(), static_cast<int>(field_key.size()), CPLES_SQL), CPLFree);
  return fmt::format("{} = '{}'", kFieldKey, quoted.get());
}

Rows::Rows(const fs::path& path, const FileKind& kind, GdalErrors& errors)
    : path_(path), kind_(kind), errors_(errors) {
  require_whole(path, kind);
  start_gdal();
  RegisterOGRGeoPackage();
  const char* const drivers[] = {"GPKG", nullptr};
  file_.reset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  if (file_ == nullptr) throw no_geopackage(path, kind);
}

void Rows::each(const char* name, const std::function<void(const Row&)>& take) {
  OGRLayer* layer = file_->GetLayerByName(name);
  if (layer == nullptr)
    throw bad_input(
        fmt::format("{}: there is no layer '{}', so this is not a complete {}; give a {} written by {}",
                    path_.string(), name, kind_.what, kind_.what, kind_.writer));
  if (key_) layer->SetAttributeFilter(filter_for(*key_).c_str());
  layer->ResetReading();
  while (const OGRFeatureUniquePtr feature{layer->GetNextFeature()})
    take(Row(*feature, fmt::format("{}: layer {}, feature {}", path_.string(), name, feature->GetFID()),
             to_local_, kind_));
  // GDAL ends a damaged layer as if it were complete, and only reports.
  if (errors_.any())
    throw bad_input(fmt::format("{}: layer {} cannot be read completely ({}); write the {} again",
                                path_.string(), name, errors_.first(), kind_.what));
}

}  // namespace tramline::io
