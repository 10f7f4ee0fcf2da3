#include "tramline/io/log/vector_log.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/most_fixes.h"
#include "tramline/io/log/fix_rows.h"
#include "tramline/io/log/settle_positions.h"
#include "tramline/io/log/width_unit.h"
#include "tramline/io/log/worked_shapes.h"
#include "tramline/io/vector/choose_layers.h"
#include "tramline/io/vector/flatten_geometry.h"
#include "tramline/io/vector/gdal_drivers.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/layer_crs.h"
#include "tramline/io/vector/open_dataset.h"

namespace tramline::io {
namespace {

bool may_hold(OGRLayer& layer, bool polygons) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  if (polygons) return type == wkbPolygon || type == wkbMultiPolygon || type == wkbCurvePolygon;
  return type == wkbPoint || type == wkbMultiPoint || type == wkbUnknown;
}

OGRLayer& choose_layer(GDALDataset& dataset, const std::string& wanted, const std::string& path) {
  if (!wanted.empty()) {
    if (OGRLayer* layer = dataset.GetLayerByName(wanted.c_str())) return *layer;
    throw bad_input(fmt::format("'{}' has no layer '{}'; found {}", path, wanted, layer_list(dataset)));
  }
  for (const bool polygons : {false, true}) {
    std::vector<OGRLayer*> fitting;
    for (OGRLayer* layer : dataset.GetLayers())
      if (may_hold(*layer, polygons)) fitting.push_back(layer);
    if (fitting.size() > 1)
      throw bad_input(fmt::format("'{}' has several layers with {}; choose one with --log: {}", path,
                                  polygons ? "polygons" : "points", layer_list(dataset)));
    if (!fitting.empty()) return *fitting.front();
  }
  throw bad_input(
      fmt::format("'{}' has no layer with points or polygons; found {}", path, layer_list(dataset)));
}

std::vector<std::string> attribute_names(OGRLayer& layer) {
  std::vector<std::string> out;
  const OGRFeatureDefn& schema = *layer.GetLayerDefn();
  for (int i = 0; i < schema.GetFieldCount(); ++i) out.emplace_back(schema.GetFieldDefn(i)->GetNameRef());
  return out;
}

std::vector<std::string> attributes_of(const OGRFeature& feature) {
  std::vector<std::string> out;
  for (int i = 0; i < feature.GetFieldCount(); ++i)
    out.emplace_back(feature.IsFieldSetAndNotNull(i) ? feature.GetFieldAsString(i) : "");
  return out;
}

void sort_by_time(WorkLog& log) {
  const auto earlier = [](const Fix& a, const Fix& b) { return a.time_s < b.time_s; };
  const bool timed =
      std::none_of(log.fixes.begin(), log.fixes.end(), [](const Fix& fix) { return std::isnan(fix.time_s); });
  if (!timed || std::is_sorted(log.fixes.begin(), log.fixes.end(), earlier)) return;
  std::stable_sort(log.fixes.begin(), log.fixes.end(), earlier);
  log.notes.emplace_back("the features are not in order of time and were sorted");
}

/// Makes fixes of features, one after the other.
class Features {
 public:
  Features(FixRows& rows, std::string place) : rows_(rows), place_(std::move(place)) {}

  void add(const OGRFeature& feature, AxisOrder axes) {
    ++record_;
    RawFeature raw;
    flatten_geometry(feature.GetGeometryRef(), axes, raw);
    const bool is_point = raw.points.size() == 1 && raw.polygons.empty() && raw.lines.empty();
    if (!polygons_ && (is_point || !raw.polygons.empty())) polygons_ = !is_point;
    const std::vector<std::string> cells = attributes_of(feature);
    cells_.assign(cells.begin(), cells.end());
    if (polygons_.value_or(false))
      add_shapes(raw);
    else if (is_point && std::isfinite(raw.points.front().x) && std::isfinite(raw.points.front().y))
      add_fix(raw.points.front());
    else
      log_.skipped.add(record_, "no point");
  }

  WorkLog finish() {
    if (log_.fixes.empty())
      throw bad_input(fmt::format("{} has no feature with a point or a polygon", place_));
    if (polygons_.value_or(false)) finish_shapes(log_, rows_, place_);
    return std::move(log_);
  }
  const std::vector<RecordedDistance>& distances() const { return distances_; }

 private:
  void add_shapes(const RawFeature& raw) {
    std::vector<Polygon> shapes = worked_shapes(raw);
    if (shapes.empty()) log_.skipped.add(record_, "no polygon");
    for (Polygon& shape : shapes) {
      if (!add_fix(bounds(shape.outer).centre())) continue;
      log_.fixes.back().shape = static_cast<int>(log_.shapes.size());
      log_.shapes.push_back(std::move(shape));
    }
  }

  bool add_fix(Point at) {
    const auto fix = rows_.add(cells_, record_, at);
    if (!fix) return false;
    require_room_for_fix(log_.fixes.size(), place_);
    log_.fixes.push_back(*fix);
    const bool once = distances_.empty() || distances_.back().record < record_;
    if (once && std::isfinite(rows_.last_distance())) distances_.push_back({record_, rows_.last_distance()});
    return true;
  }

  FixRows& rows_;
  std::string place_;
  std::optional<bool> polygons_;
  std::size_t record_ = 0;
  std::vector<std::string_view> cells_;
  WorkLog log_;
  std::vector<RecordedDistance> distances_;
};

}  // namespace

WorkLog read_vector_log(const std::string& path, const std::string& wanted, const std::string& columns,
                        const std::string& crs) {
  register_gdal_drivers();
  GdalMessages messages;
  const auto connections = connections_for(path);
  const GDALDatasetUniquePtr dataset = open_dataset(path, wanted, messages);
  OGRLayer& layer = choose_layer(*dataset, wanted, path);
  const std::string place = fmt::format("layer '{}' of '{}'", layer.GetName(), path);
  const std::string declared = layer_crs(layer.GetSpatialRef(), place);
  const AxisOrder axes = axis_order(layer.GetSpatialRef());
  const std::vector<std::string> names = attribute_names(layer);
  FixRows rows(names, TableForm{place, columns, PositionSource::kElsewhere, false});
  Features features(rows, place);
  layer.ResetReading();
  messages.clear();
  while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) features.add(*feature, axes);
  if (messages.failed())
    throw bad_input(fmt::format("{} is damaged ({}); fetch or export it again", place, messages.last()));
  WorkLog log = features.finish();
  log.booms = rows.booms();
  log.clock = rows.clock();
  log.rate_unit = rows.rate_unit();
  log.counters = rows.counters();
  const std::vector<std::string> notes = rows.notes();
  log.notes.insert(log.notes.begin(), notes.begin(), notes.end());
  settle_positions(log, PositionNames::kEither, crs.empty() ? declared : crs, place);
  if (rows.width_unit_open()) settle_width_unit(log, features.distances());
  sort_by_time(log);
  return log;
}

}  // namespace tramline::io
