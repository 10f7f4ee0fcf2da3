#include "tramline/io/vector/read_vector.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/choose_layers.h"
#include "tramline/io/vector/gdal_drivers.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/layer_crs.h"
#include "tramline/io/vector/layer_reading.h"
#include "tramline/io/vector/locate_dataset.h"
#include "tramline/io/vector/open_dataset.h"

namespace tramline::io {
namespace {

RawLayer read_layer(OGRLayer& layer, const VectorQuery& query, GdalMessages& messages) {
  const std::string place = place_of(layer, query);
  RawLayer out = bare_layer(layer, query);
  const AxisOrder axes = axis_order(layer.GetSpatialRef());
  filter(layer, query, place, messages);
  messages.clear();
  if (query.fid) {
    const OGRFeatureUniquePtr feature(layer.GetFeature(*query.fid));
    if (!feature) throw bad_input(fmt::format("{} has no feature with number {}", place, *query.fid));
    out.features.push_back(raw_feature(*feature, axes, query));
    out.matching = 1;
    return out;
  }
  layer.ResetReading();
  while (query.limit < 0 || std::ssize(out.features) < query.limit) {
    const OGRFeatureUniquePtr feature(layer.GetNextFeature());
    if (!feature) break;
    out.features.push_back(raw_feature(*feature, axes, query));
    check_reading(layer, query, place, messages);
  }
  check_reading(layer, query, place, messages);
  const bool stopped = query.limit >= 0 && std::ssize(out.features) == query.limit;
  out.matching = stopped ? layer.GetFeatureCount(true) : std::ssize(out.features);
  return out;
}

void refuse_empty(const RawDataset& dataset, const VectorQuery& query) {
  for (const RawLayer& layer : dataset.layers)
    if (!layer.features.empty()) return;
  const std::string file = shown_name(query.file);
  if (!query.where.empty())
    throw bad_input(
        fmt::format("no feature of '{}' matches {} \"{}\"", file, where_option(query), query.where));
  throw bad_input(fmt::format("'{}' holds no features; give a file with {}", file,
                              query.shapes == WantedShapes::kLines ? "lines" : "field boundaries"));
}

}  // namespace

RawDataset read_vector(const VectorQuery& query) {
  register_gdal_drivers();
  GdalMessages messages;
  const auto connections = connections_for(query.file);
  const GDALDatasetUniquePtr dataset = open_dataset(query.file, query.layer, messages);
  RawDataset out = bare_dataset(*dataset, query);
  for (OGRLayer* layer : choose_layers(*dataset, query, out.skipped))
    out.layers.push_back(read_layer(*layer, query, messages));
  refuse_empty(out, query);
  return out;
}

}  // namespace tramline::io
