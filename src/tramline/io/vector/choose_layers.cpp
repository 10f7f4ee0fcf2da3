#include "tramline/io/vector/choose_layers.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::io {
namespace {

bool may_hold_polygons(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type == wkbUnknown || type == wkbGeometryCollection || OGR_GT_IsSubClassOf(type, wkbSurface) ||
         OGR_GT_IsSubClassOf(type, wkbMultiSurface);
}

std::string described(OGRLayer& layer) {
  return fmt::format("{} ({})", layer.GetName(), OGRGeometryTypeToName(wkbFlatten(layer.GetGeomType())));
}

}  // namespace

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
    throw bad_input(fmt::format("'{}' has no layer with features; give a file with field boundaries", file));
  // The only layer is read even if it promises no polygons: its features are then refused one by one.
  if (query.all_layers || all.size() == 1) return all;
  if (with_polygons.empty())
    throw bad_input(fmt::format("'{}' has no layer with polygons; found {}", file, layer_list(dataset)));
  if (with_polygons.size() > 1)
    throw bad_input(fmt::format("'{}' has several layers with polygons; choose one with --layer: {}", file,
                                layer_list(dataset)));
  for (OGRLayer* layer : all)
    if (layer != with_polygons.front())
      skipped.push_back({fmt::format("layer {}", described(*layer)), file, "it holds no polygons"});
  return with_polygons;
}

}  // namespace tramline::io
