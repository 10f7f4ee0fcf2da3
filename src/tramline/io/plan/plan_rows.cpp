#include "tramline/io/plan/plan_rows.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

/// SQLite's header holds the page size and the number of pages, so a file cut off shows at once;
/// SQLite itself would only notice when a lost page is asked for.
void require_whole(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw bad_input(fmt::format("{}: there is no such file", path.string()));
  std::array<unsigned char, 32> header{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(header.data()), header.size());
  if (!stream || std::memcmp(header.data(), "SQLite format 3", 16) != 0)
    throw bad_input(
        fmt::format("{}: this is no GeoPackage; give a plan written by tramline plan", path.string()));
  const std::uintmax_t page = header[16] * 256u + header[17];
  const std::uintmax_t page_bytes = page == 1 ? 65536 : page;
  const std::uintmax_t pages =
      (std::uintmax_t{header[28]} << 24) + (header[29] << 16) + (header[30] << 8) + header[31];
  if (fs::file_size(path, error) < page_bytes * pages)
    throw bad_input(fmt::format("{}: the file is cut off; write the plan again", path.string()));
}

}  // namespace

double Row::number(const char* column) const {
  const double value = feature_.GetFieldAsDouble(index(column));
  if (!std::isfinite(value)) throw bad_input(fmt::format("{}: {} is not a finite number", place_, column));
  return value;
}

std::optional<double> Row::number_if_any(const char* column) const {
  const int found = feature_.GetFieldIndex(column);
  if (found >= 0 && !feature_.IsFieldSetAndNotNull(found)) return std::nullopt;
  return number(column);
}

Polygon Row::polygon() const {
  const OGRGeometry* shape = feature_.GetGeometryRef();
  if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbPolygon || shape->IsEmpty())
    throw bad_input(place_ + " has no polygon; write the plan again");
  const OGRPolygon* source = shape->toPolygon();
  Polygon out{ring(*source->getExteriorRing()), {}};
  for (int i = 0; i < source->getNumInteriorRings(); ++i)
    out.holes.push_back(ring(*source->getInteriorRing(i)));
  return out;
}

std::vector<Point> Row::line() const {
  const OGRGeometry* shape = feature_.GetGeometryRef();
  if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbLineString ||
      shape->toLineString()->getNumPoints() < 2)
    throw bad_input(place_ + " has no line of two points or more; write the plan again");
  std::vector<Point> out;
  for (int i = 0; i < shape->toLineString()->getNumPoints(); ++i)
    out.push_back(vertex(*shape->toLineString(), i));
  return out;
}

std::pair<Point, Point> Row::straight_line() const {
  const std::vector<Point> points = line();
  if (points.size() != 2)
    throw bad_input(place_ + " is no straight line of two points; write the plan again");
  return {points[0], points[1]};
}

Point Row::point() const {
  const OGRGeometry* shape = feature_.GetGeometryRef();
  if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbPoint || shape->IsEmpty())
    throw bad_input(place_ + " has no point; write the plan again");
  const Point p{shape->toPoint()->getX() - offset_.x, shape->toPoint()->getY() - offset_.y};
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw bad_input(place_ + " has no finite coordinates; write the plan again");
  return p;
}

int Row::index(const char* column) const {
  const int found = feature_.GetFieldIndex(column);
  if (found < 0 || !feature_.IsFieldSetAndNotNull(found))
    throw bad_input(fmt::format("{} has no value for {}; write the plan again", place_, column));
  return found;
}

Point Row::vertex(const OGRSimpleCurve& line, int i) const {
  const Point p{line.getX(i) - offset_.x, line.getY(i) - offset_.y};
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

PlanRows::PlanRows(const fs::path& path, GdalErrors& errors) : path_(path), errors_(errors) {
  require_whole(path);
  RegisterOGRGeoPackage();
  const char* const drivers[] = {"GPKG", nullptr};
  file_.reset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  if (file_ == nullptr)
    throw bad_input(
        fmt::format("{}: this is no GeoPackage; give a plan written by tramline plan", path.string()));
}

void PlanRows::each(const char* name, const std::function<void(const Row&)>& take) {
  OGRLayer* layer = file_->GetLayerByName(name);
  if (layer == nullptr)
    throw bad_input(
        fmt::format("{}: there is no layer '{}', so this is no whole plan; give a plan written by "
                    "tramline plan",
                    path_.string(), name));
  layer->ResetReading();
  while (const OGRFeatureUniquePtr feature{layer->GetNextFeature()})
    take(Row(*feature, fmt::format("{}: layer {}, feature {}", path_.string(), name, feature->GetFID()),
             offset_));
  // GDAL ends a damaged layer as if it were complete, and only reports.
  if (errors_.any())
    throw bad_input(fmt::format("{}: layer {} cannot be read whole ({}); write the plan again",
                                path_.string(), name, errors_.first()));
}

}  // namespace tramline::io
