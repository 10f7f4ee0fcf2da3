#include "tramline/io/log/vector_log.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/log/fix_rows.h"
#include "tramline/io/log/settle_positions.h"
#include "tramline/io/log/width_unit.h"
#include "tramline/io/vector/choose_layers.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/layer_crs.h"
#include "tramline/io/vector/open_dataset.h"

namespace tramline::io {
namespace {

bool may_hold_points(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type == wkbPoint || type == wkbMultiPoint || type == wkbUnknown;
}

OGRLayer& choose_layer(GDALDataset& dataset, const std::string& wanted, const std::string& path) {
  if (!wanted.empty()) {
    if (OGRLayer* layer = dataset.GetLayerByName(wanted.c_str())) return *layer;
    throw bad_input(fmt::format("'{}' has no layer '{}'; found {}", path, wanted, layer_list(dataset)));
  }
  std::vector<OGRLayer*> with_points;
  for (OGRLayer* layer : dataset.GetLayers())
    if (may_hold_points(*layer)) with_points.push_back(layer);
  if (with_points.empty())
    throw bad_input(fmt::format("'{}' has no layer with points; found {}", path, layer_list(dataset)));
  if (with_points.size() > 1)
    throw bad_input(fmt::format("'{}' has several layers with points; choose one with --log: {}", path,
                                layer_list(dataset)));
  return *with_points.front();
}

std::optional<Point> point_of(const OGRGeometry* geometry, bool swap_axes) {
  if (geometry == nullptr || geometry->IsEmpty()) return std::nullopt;
  if (wkbFlatten(geometry->getGeometryType()) == wkbMultiPoint &&
      geometry->toMultiPoint()->getNumGeometries() == 1)
    return point_of(geometry->toMultiPoint()->getGeometryRef(0), swap_axes);
  if (wkbFlatten(geometry->getGeometryType()) != wkbPoint) return std::nullopt;
  const OGRPoint& point = *geometry->toPoint();
  const Point at = {point.getX(), point.getY()};
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return std::nullopt;
  return swap_axes ? Point{at.y, at.x} : at;
}

std::vector<std::string> attribute_names(OGRLayer& layer) {
  std::vector<std::string> out;
  const OGRFeatureDefn& schema = *layer.GetLayerDefn();
  for (int i = 0; i < schema.GetFieldCount(); ++i) out.emplace_back(schema.GetFieldDefn(i)->GetNameRef());
  return out;
}

void sort_by_time(WorkLog& log) {
  const auto earlier = [](const Fix& a, const Fix& b) { return a.time_s < b.time_s; };
  const bool timed =
      std::none_of(log.fixes.begin(), log.fixes.end(), [](const Fix& fix) { return std::isnan(fix.time_s); });
  if (!timed || std::is_sorted(log.fixes.begin(), log.fixes.end(), earlier)) return;
  std::stable_sort(log.fixes.begin(), log.fixes.end(), earlier);
  log.notes.emplace_back("the features are not in the order of their times and were put into it");
}

}  // namespace

WorkLog read_vector_log(const std::string& path, const std::string& wanted, const std::string& columns,
                        const std::string& crs) {
  register_gdal_drivers();
  GdalMessages messages;
  const GDALDatasetUniquePtr dataset = open_dataset(path, wanted, messages);
  OGRLayer& layer = choose_layer(*dataset, wanted, path);
  const std::string place = fmt::format("layer '{}' of '{}'", layer.GetName(), path);
  const std::string declared = layer_crs(layer.GetSpatialRef(), place);
  const bool swap_axes = axes_are_swapped(layer.GetSpatialRef());
  const std::vector<std::string> names = attribute_names(layer);
  FixRows rows(names, TableForm{place, columns, false, false});
  WorkLog log;
  std::vector<RecordedDistance> distances;
  std::size_t record = 0;
  layer.ResetReading();
  messages.clear();
  while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
    std::vector<std::string> cells;
    for (int i = 0; i < feature->GetFieldCount(); ++i)
      cells.emplace_back(feature->IsFieldSetAndNotNull(i) ? feature->GetFieldAsString(i) : "");
    const std::vector<std::string_view> views(cells.begin(), cells.end());
    ++record;
    const auto at = point_of(feature->GetGeometryRef(), swap_axes);
    if (!at) {
      log.skipped.add(record, "no point");
      continue;
    }
    const auto fix = rows.add(views, record, at);
    if (!fix) continue;
    log.fixes.push_back(*fix);
    if (std::isfinite(rows.last_distance())) distances.push_back({record, rows.last_distance()});
  }
  if (messages.failed())
    throw bad_input(fmt::format("{} is damaged ({}); fetch or export it again", place, messages.last()));
  if (log.fixes.empty()) throw bad_input(fmt::format("{} has no feature with a point", place));
  log.booms = rows.booms();
  log.clock = rows.clock();
  log.rate_unit = rows.rate_unit();
  log.notes = rows.notes();
  settle_positions(log, PositionNames::kEither, crs.empty() ? declared : crs, place);
  if (rows.width_unit_open()) settle_width_unit(log, distances);
  sort_by_time(log);
  return log;
}

}  // namespace tramline::io
