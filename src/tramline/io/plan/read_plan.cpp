#include "tramline/io/plan/read_plan.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <memory>

#include "tramline/geometry/error.h"
#include "tramline/io/plan/gdal_errors.h"
#include "tramline/io/plan/local_crs.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/plan_metadata.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;
namespace layers = plan_layers;

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

/// One feature, with its place for messages. Shapes come back in local metres.
class Row {
 public:
  Row(const OGRFeature& feature, std::string place, Point offset)
      : feature_(feature), place_(std::move(place)), offset_(offset) {}

  const std::string& place() const { return place_; }

  double number(const char* column) const {
    const double value = feature_.GetFieldAsDouble(index(column));
    if (!std::isfinite(value)) throw bad_input(fmt::format("{}: {} is not a finite number", place_, column));
    return value;
  }
  int whole(const char* column) const { return feature_.GetFieldAsInteger(index(column)); }
  bool flag(const char* column) const { return whole(column) != 0; }
  std::string text(const char* column) const { return feature_.GetFieldAsString(index(column)); }

  Polygon polygon() const {
    const OGRGeometry* shape = feature_.GetGeometryRef();
    if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbPolygon || shape->IsEmpty())
      throw bad_input(place_ + " has no polygon; write the plan again");
    const OGRPolygon* source = shape->toPolygon();
    Polygon out{ring(*source->getExteriorRing()), {}};
    for (int i = 0; i < source->getNumInteriorRings(); ++i)
      out.holes.push_back(ring(*source->getInteriorRing(i)));
    return out;
  }

  std::pair<Point, Point> line() const {
    const OGRGeometry* shape = feature_.GetGeometryRef();
    if (shape == nullptr || wkbFlatten(shape->getGeometryType()) != wkbLineString ||
        shape->toLineString()->getNumPoints() != 2)
      throw bad_input(place_ + " is no straight line of two points; write the plan again");
    return {point(*shape->toLineString(), 0), point(*shape->toLineString(), 1)};
  }

 private:
  int index(const char* column) const {
    const int found = feature_.GetFieldIndex(column);
    if (found < 0 || !feature_.IsFieldSetAndNotNull(found))
      throw bad_input(fmt::format("{} has no value for {}; write the plan again", place_, column));
    return found;
  }
  Point point(const OGRLineString& line, int i) const {
    const Point p{line.getX(i) - offset_.x, line.getY(i) - offset_.y};
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      throw bad_input(fmt::format("{}: vertex {} has no finite coordinates", place_, i));
    return p;
  }
  Ring ring(const OGRLinearRing& closed) const {
    Ring out;
    for (int i = 0; i + 1 < closed.getNumPoints(); ++i) out.push_back(point(closed, i));
    if (out.size() < 3) throw bad_input(place_ + " has a ring of fewer than three vertices");
    return out;
  }

  const OGRFeature& feature_;
  std::string place_;
  Point offset_;
};

class File {
 public:
  File(const fs::path& path, GdalErrors& errors) : path_(path), errors_(errors) {
    RegisterOGRGeoPackage();
    const char* const drivers[] = {"GPKG", nullptr};
    file_.reset(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
    if (file_ == nullptr)
      throw bad_input(
          fmt::format("{}: this is no GeoPackage; give a plan written by tramline plan", path.string()));
  }

  void shift_by(Point offset) { offset_ = offset; }

  /// Hands every feature of a layer to `take`, in the order of the file.
  void each(const char* name, const std::function<void(const Row&)>& take) {
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

 private:
  fs::path path_;
  GdalErrors& errors_;
  GDALDatasetUniquePtr file_;
  Point offset_;
};

void derive(PlanFile& out, const Row& row, const char* column, double from_shape, Point at) {
  out.derived.push_back({row.place().substr(row.place().find(": layer ") + 2) + ", " + column,
                         row.number(column), from_shape, at});
}

void derive_area(PlanFile& out, const Row& row, const Polygon& polygon) {
  derive(out, row, "area_m2", area(polygon), polygon.outer.front());
}

void read_region(File& file, const char* name, Region& into, PlanFile& out) {
  file.each(name, [&](const Row& row) {
    into.push_back(row.polygon());
    derive_area(out, row, into.back());
  });
}

void read_field(File& file, const fs::path& path, PlanFile& out) {
  Field& field = out.plan.field;
  int count = 0;
  file.each(layers::kField, [&](const Row& row) {
    field.outer = row.polygon().outer;
    ++count;
    derive_area(out, row, {field.outer, {}});
  });
  if (count != 1)
    throw bad_input(fmt::format("{}: layer field holds {} features instead of one; write the plan again",
                                path.string(), count));
  file.each(layers::kObstacles, [&](const Row& row) {
    Obstacle obstacle{row.polygon(), ObstacleKind::kObstacle, row.text("origin")};
    const std::string kind = row.text("kind");
    if (kind != layers::kObstacle && kind != layers::kPassable)
      throw bad_input(fmt::format("{}: kind is '{}', expected obstacle or passable", row.place(), kind));
    if (kind == layers::kPassable) obstacle.kind = ObstacleKind::kPassable;
    derive_area(out, row, obstacle.shape);
    field.obstacles.push_back(std::move(obstacle));
  });
}

void read_subfields(File& file, PlanFile& out) {
  file.each(layers::kSubfields, [&](const Row& row) {
    const Angle angle = Angle::radians(row.number("direction_rad"));
    out.plan.subfields.push_back({row.polygon(), Direction::clockwise_from_north(angle)});
    const Subfield& subfield = out.plan.subfields.back();
    derive_area(out, row, subfield.shape);
    derive(out, row, "direction_deg", subfield.direction.degrees(), subfield.shape.outer.front());
    derive(out, row, "number", static_cast<double>(out.plan.subfields.size()), subfield.shape.outer.front());
  });
}

/// Rows of a layer sorted by their column order.
template <class Item>
void sort_into(std::vector<std::pair<int, Item>>& rows, std::vector<int>& order, std::vector<Item>& items) {
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [number, item] : rows) {
    order.push_back(number);
    items.push_back(std::move(item));
  }
}

void read_tracks(File& file, PlanFile& out) {
  std::vector<std::pair<int, TrackPiece>> rows;
  file.each(layers::kTracks, [&](const Row& row) {
    TrackPiece piece;
    std::tie(piece.start, piece.end) = row.line();
    piece.subfield = row.whole("subfield") - 1;
    piece.track = row.whole("track") - 1;
    piece.stop_at_start = row.flag("stop_at_start");
    piece.stop_at_end = row.flag("stop_at_end");
    piece.after_crossing = row.flag("after_crossing");
    derive(out, row, "length_m", length(piece), piece.start);
    derive(out, row, "heading_deg", Heading::from_to(piece.start, piece.end).degrees(), piece.start);
    rows.emplace_back(row.whole("order"), piece);
  });
  sort_into(rows, out.track_order, out.plan.pieces);
}

void read_swaths(File& file, PlanFile& out) {
  std::vector<std::pair<int, Polygon>> rows;
  file.each(layers::kSwaths, [&](const Row& row) {
    rows.emplace_back(row.whole("order"), row.polygon());
    const Polygon& swath = rows.back().second;
    derive_area(out, row, swath);
    derive(out, row, "width_m", out.plan.machine.width_m, swath.outer.front());
  });
  sort_into(rows, out.swath_order, out.swaths);
}

void read_dropped(File& file, PlanFile& out) {
  file.each(layers::kDropped, [&](const Row& row) {
    const auto [start, end] = row.line();
    out.plan.dropped.push_back({start, end, row.whole("subfield") - 1});
    derive(out, row, "length_m", distance(start, end), start);
  });
}

}  // namespace

PlanFile read_plan_file(const fs::path& path) {
  require_whole(path);
  GdalErrors errors;
  File file(path, errors);
  PlanFile out;
  Metadata metadata;
  file.each(layers::kMetadata, [&](const Row& row) { metadata[row.text("key")] = row.text("value"); });
  apply_metadata(metadata, path, out.plan);
  file.shift_by(offset_of(out.plan.field.frame));

  read_field(file, path, out);
  read_region(file, layers::kBody, out.plan.body, out);
  read_region(file, layers::kGivenUp, out.plan.given_up, out);
  read_subfields(file, out);
  read_tracks(file, out);
  read_swaths(file, out);
  read_region(file, layers::kOverlap, out.plan.overlap, out);
  read_region(file, layers::kUncovered, out.plan.uncovered, out);
  read_dropped(file, out);
  return out;
}

Plan read_plan(const fs::path& path) { return read_plan_file(path).plan; }

}  // namespace tramline::io
