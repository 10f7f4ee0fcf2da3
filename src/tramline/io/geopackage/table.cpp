#include "tramline/io/geopackage/table.h"

#include <cpl_error.h>
#include <cpl_string.h>

#include <cmath>

#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

void set(OGRFeature& feature, int column, const Cell& cell) {
  if (const auto* whole = std::get_if<long long>(&cell)) feature.SetField(column, GIntBig{*whole});
  if (const auto* number = std::get_if<double>(&cell)) feature.SetField(column, plain_zero(*number));
  if (const auto* yes = std::get_if<bool>(&cell)) feature.SetField(column, *yes ? 1 : 0);
  if (const auto* word = std::get_if<std::string>(&cell)) feature.SetField(column, word->c_str());
}

}  // namespace

Cell number_if(const std::optional<double>& number) { return number ? Cell(*number) : Cell(); }

Cell number_unless_nan(double number) { return std::isnan(number) ? Cell() : Cell(number); }

std::unique_ptr<OGRGeometry> Shapes::point(Point p) const {
  const Point placed = this->placed(p);
  return std::make_unique<OGRPoint>(placed.x, placed.y);
}

std::unique_ptr<OGRGeometry> Shapes::line(const std::vector<Point>& points) const {
  auto out = std::make_unique<OGRLineString>();
  append(*out, points, false);
  return out;
}

std::unique_ptr<OGRGeometry> Shapes::polygon(const Polygon& polygon) const {
  auto out = std::make_unique<OGRPolygon>();
  for (const Ring& ring : rings_of({polygon})) {
    auto closed = std::make_unique<OGRLinearRing>();
    append(*closed, ring, true);
    out->addRingDirectly(closed.release());
  }
  return out;
}

std::unique_ptr<OGRGeometry> Shapes::region(const Region& region) const {
  auto out = std::make_unique<OGRMultiPolygon>();
  for (const Polygon& part : region) out->addGeometryDirectly(polygon(part).release());
  return out;
}

Point Shapes::placed(Point p) const {
  const Point out = project_ ? project_(p) : p + offset_;
  return {plain_zero(out.x), plain_zero(out.y)};
}

void Shapes::append(OGRLineString& out, const std::vector<Point>& points, bool closed) const {
  const std::size_t n = points.size();
  const std::size_t written = closed && n > 0 ? n + 1 : n;
  out.setNumPoints(static_cast<int>(written), FALSE);
  for (std::size_t i = 0; i < written; ++i) {
    const Point p = placed(points[i % n]);
    out.setPoint(static_cast<int>(i), p.x, p.y);
  }
}

Table::Table(GDALDataset& file, const char* name, OGRwkbGeometryType type, OGRSpatialReference* crs,
             std::initializer_list<Column> columns, const char* key)
    : layer_(file.CreateLayer(name, crs, type, CPLStringList().SetNameValue("FID", key).List())) {
  add_columns(columns);
}

Table::Table(const Target& target, const char* name, OGRwkbGeometryType type,
             std::initializer_list<Column> columns)
    : layer_(target.names == nullptr ? nullptr : target.file.GetLayerByName(name)), names_(target.names) {
  if (layer_ != nullptr) return;
  layer_ = target.file.CreateLayer(name, type == wkbNone ? nullptr : target.crs, type,
                                   CPLStringList().SetNameValue("FID", "fid").List());
  if (names_ != nullptr) add_columns({text(kFieldKey), text(kFieldId)});
  add_columns(columns);
}

void Table::add_columns(std::initializer_list<Column> columns) {
  if (layer_ == nullptr) return;
  for (const Column& column : columns) {
    OGRFieldDefn definition(column.name, column.type);
    definition.SetSubType(column.subtype);
    layer_->CreateField(&definition);
  }
}

void Table::add(std::unique_ptr<OGRGeometry> shape, std::initializer_list<Cell> cells) {
  if (layer_ == nullptr) return;
  OGRFeature feature(layer_->GetLayerDefn());
  int column = 0;
  if (names_ != nullptr) {
    set(feature, column++, names_->key);
    set(feature, column++, names_->id);
  }
  for (const Cell& cell : cells) set(feature, column++, cell);
  if (shape != nullptr) feature.SetGeometryDirectly(shape.release());
  if (layer_->CreateFeature(&feature) != OGRERR_NONE)
    CPLError(CE_Failure, CPLE_AppDefined, "a feature of layer %s was refused", layer_->GetName());
}

}  // namespace tramline::io
