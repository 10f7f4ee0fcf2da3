#include "tramline/io/vector/choose_layers.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::io {
namespace {

bool may_hold_polygons(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type == wkbUnknown || type == wkbGeometryCollection || OGR_GT_IsSubClassOf(type, wkbSurface) ||
         OGR_GT_IsSubClassOf(type, wkbMultiSurface);
}

bool may_hold_lines(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type == wkbUnknown || type == wkbGeometryCollection || OGR_GT_IsCurve(type) ||
         OGR_GT_IsSubClassOf(type, wkbMultiCurve);
}

std::string described(OGRLayer& layer) {
  return fmt::format("{} ({})", layer.GetName(), OGRGeometryTypeToName(wkbFlatten(layer.GetGeomType())));
}

/// The layers of an export of ours that hold what is driven: tracks and headland passes.
std::vector<OGRLayer*> exported_layers(const std::vector<OGRLayer*>& all) {
  const auto find = [&](const char* name) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](OGRLayer* layer) { return std::string(layer->GetName()) == name; });
    return found == all.end() ? nullptr : *found;
  };
  OGRLayer* const tracks = find("tracks");
  OGRLayer* const passes = find("headland_passes");
  if (tracks == nullptr || tracks->GetLayerDefn()->GetFieldIndex("order") < 0) return {};
  if (passes == nullptr || passes->GetLayerDefn()->GetFieldIndex("number") < 0) return {tracks};
  return {tracks, passes};
}

std::vector<OGRLayer*> layers_with_lines(GDALDataset& dataset, const std::vector<OGRLayer*>& all,
                                         const std::string& file, std::vector<Skipped>& skipped) {
  std::vector<OGRLayer*> chosen = exported_layers(all);
  if (!chosen.empty()) return chosen;
  bool polygons = false;
  for (OGRLayer* layer : all) {
    polygons = polygons || (!may_hold_lines(*layer) && may_hold_polygons(*layer));
    if (may_hold_lines(*layer) && layer->GetFeatureCount() != 0) chosen.push_back(layer);
  }
  if (chosen.empty())
    throw bad_input(fmt::format(
        "'{}' {}; found {}", file,
        polygons ? "holds areas, not lines: give a file with the centre lines" : "has no layer with lines",
        layer_list(dataset)));
  if (chosen.size() > 1)
    throw bad_input(fmt::format("'{}' has several layers with lines; choose one with --lines-layer: {}", file,
                                layer_list(dataset)));
  for (OGRLayer* layer : all)
    if (std::find(chosen.begin(), chosen.end(), layer) == chosen.end())
      skipped.push_back({fmt::format("layer {}", described(*layer)), file,
                         may_hold_lines(*layer) ? "it holds no features" : "it holds no lines"});
  return chosen;
}

}  // namespace

const char* where_option(const VectorQuery& query) {
  return query.shapes == WantedShapes::kLines ? "--lines-where" : "--where";
}

const char* layer_option(const VectorQuery& query) {
  return query.shapes == WantedShapes::kLines ? "--lines-layer" : "--layer";
}

std::string layer_list(GDALDataset& dataset) {
  std::string out;
  for (OGRLayer* layer : dataset.GetLayers()) out += (out.empty() ? "" : ", ") + described(*layer);
  return out.empty() ? "none" : out;
}

std::vector<OGRLayer*> choose_layers(GDALDataset& dataset, const VectorQuery& query,
                                     std::vector<Skipped>& skipped) {
  const std::string file = shown_name(query.file);
  if (!query.layer.empty()) {
    OGRLayer* layer = dataset.GetLayerByName(query.layer.c_str());
    if (layer != nullptr) return {layer};
    if (!query.layer_is_hint)
      throw bad_input(
          fmt::format("'{}' has no layer '{}'; found {}", file, query.layer, layer_list(dataset)));
  }
  std::vector<OGRLayer*> all, with_polygons;
  for (OGRLayer* layer : dataset.GetLayers()) {
    all.push_back(layer);
    if (may_hold_polygons(*layer)) with_polygons.push_back(layer);
  }
  if (all.empty())
    throw bad_input(fmt::format("'{}' has no layer with features; give a file with {}", file,
                                query.shapes == WantedShapes::kLines ? "lines" : "field boundaries"));
  // The only layer is read even if it promises no polygons: its features are then refused one by one.
  if (query.all_layers || all.size() == 1) return all;
  if (query.shapes == WantedShapes::kLines) return layers_with_lines(dataset, all, file, skipped);
  if (with_polygons.empty())
    throw bad_input(fmt::format("'{}' has no layer with polygons; found {}", file, layer_list(dataset)));
  if (with_polygons.size() > 1)
    throw bad_input(fmt::format("'{}' has several layers with polygons; choose one with {}: {}", file,
                                layer_option(query), layer_list(dataset)));
  for (OGRLayer* layer : all)
    if (layer != with_polygons.front())
      skipped.push_back({fmt::format("layer {}", described(*layer)), file, "it holds no polygons"});
  return with_polygons;
}

}  // namespace tramline::io
