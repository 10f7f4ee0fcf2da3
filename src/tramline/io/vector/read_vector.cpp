#include "tramline/io/vector/read_vector.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/choose_layers.h"
#include "tramline/io/vector/feature_id.h"
#include "tramline/io/vector/flatten_geometry.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::io {
namespace {

GDALDatasetUniquePtr open(const std::string& name, GdalMessages& messages) {
  // Only the GeoJSON driver knows the option; it keeps whole-number ids apart from counted ones.
  const char* const options[] = {"NATIVE_DATA=YES", nullptr};
  // Some drivers take any folder and pick a file of their kind from it.
  const char* const folder_drivers[] = {"ESRI Shapefile", "OpenFileGDB", nullptr};
  messages.clear();
  return GDALDatasetUniquePtr(GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                                is_folder(name) ? folder_drivers : nullptr, options,
                                                nullptr));
}

/// A zip may hold several datasets: the one with the wanted layer, or the only one.
GDALDatasetUniquePtr open_one(const VectorQuery& query, GdalMessages& messages) {
  const std::string file = shown_name(query.file);
  const std::vector<std::string> names = locate_datasets(query.file);
  if (names.size() > 1) {
    if (!query.layer.empty())
      for (const std::string& name : names) {
        GDALDatasetUniquePtr dataset = open(name, messages);
        if (dataset && dataset->GetLayerByName(query.layer.c_str()) != nullptr) return dataset;
      }
    std::vector<std::string> inner;
    for (const std::string& name : names) inner.push_back(name.substr(name.find('}') + 1));
    throw bad_input(fmt::format(
        "'{}' holds several vector files{}; unpack the one you mean or name its layer with "
        "--layer: {}",
        file, query.layer.empty() ? "" : ", none with layer '" + query.layer + "'", fmt::join(inner, ", ")));
  }
  GDALDatasetUniquePtr dataset = open(names.front(), messages);
  if (dataset) return dataset;
  if (is_folder(names.front()))
    throw bad_input(fmt::format("'{}' is a folder without Shapefiles; name a file in it", file));
  if (is_database_string(query.file))
    throw bad_input(fmt::format("'{}' cannot be opened: {}", file, messages.last()));
  throw bad_input(
      fmt::format("'{}' cannot be read as a vector file{}; give an undamaged GeoJSON, GeoPackage, Shapefile, "
                  "FlatGeobuf, KML or GML file",
                  file, messages.failed() ? " (" + messages.last() + ")" : ""));
}

/// WKT of the layer's CRS; empty for none and for the "undefined" ones GeoPackage prescribes.
std::string crs_of(const OGRSpatialReference* srs, const std::string& place) {
  if (srs == nullptr || srs->IsEmpty()) return {};
  const char* name = srs->GetName();
  if (name != nullptr && std::string(name).rfind("Undefined", 0) == 0) return {};
  if (srs->IsLocal()) {
    if (srs->GetLinearUnits() == 1.0) return {};
    throw bad_input(
        fmt::format("{} is in a local grid with units other than metres; convert it to metres", place));
  }
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
  const OGRErr status = srs->exportToWkt(&text, options);
  std::string out = status == OGRERR_NONE && text != nullptr ? text : "";
  CPLFree(text);
  return out;
}

/// OGR hands out longitude first whatever the authority says, unless a driver maps the axes otherwise.
bool axes_are_swapped(const OGRSpatialReference* srs) {
  if (srs == nullptr) return false;
  OGRSpatialReference traditional(*srs);
  traditional.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return srs->GetDataAxisToSRSAxisMapping() != traditional.GetDataAxisToSRSAxisMapping();
}

RawFeature raw_feature(const OGRFeature& feature, bool swap_axes) {
  RawFeature out;
  out.fid = feature.GetFID();
  out.id = feature_id(feature);
  flatten_geometry(feature.GetGeometryRef(), swap_axes, out);
  return out;
}

std::string attribute_list(OGRLayer& layer) {
  std::string out = layer.GetFIDColumn();
  const OGRFeatureDefn& schema = *layer.GetLayerDefn();
  for (int i = 0; i < schema.GetFieldCount(); ++i)
    out += (out.empty() ? "" : ", ") + std::string(schema.GetFieldDefn(i)->GetNameRef());
  return out.empty() ? "none" : out;
}

/// Some drivers notice only while reading that the filter makes no sense.
Error filter_fault(OGRLayer& layer, const VectorQuery& query, const std::string& place,
                   const GdalMessages& messages) {
  return bad_input(fmt::format("--where \"{}\" is not a filter for {}, whose attributes are {}: {}",
                               query.where, place, attribute_list(layer), messages.last()));
}

void filter(OGRLayer& layer, const VectorQuery& query, const std::string& place, GdalMessages& messages) {
  messages.clear();
  if (query.where.empty()) return;
  if (layer.SetAttributeFilter(query.where.c_str()) != OGRERR_NONE || messages.failed())
    throw filter_fault(layer, query, place, messages);
}

void check_reading(OGRLayer& layer, const VectorQuery& query, const std::string& place,
                   const GdalMessages& messages) {
  if (!messages.failed()) return;
  if (!query.where.empty()) throw filter_fault(layer, query, place, messages);
  throw bad_input(fmt::format("{} is damaged ({}); fetch or export it again", place, messages.last()));
}

RawLayer read_layer(OGRLayer& layer, const VectorQuery& query, GdalMessages& messages) {
  const std::string place = fmt::format("layer '{}' of '{}'", layer.GetName(), shown_name(query.file));
  const OGRSpatialReference* srs = layer.GetSpatialRef();
  RawLayer out{
      layer.GetName(), OGRGeometryTypeToName(wkbFlatten(layer.GetGeomType())), crs_of(srs, place), {}, 0};
  const bool swap_axes = axes_are_swapped(srs);
  filter(layer, query, place, messages);
  messages.clear();
  if (query.fid) {
    const OGRFeatureUniquePtr feature(layer.GetFeature(*query.fid));
    if (!feature) throw bad_input(fmt::format("{} has no feature with number {}", place, *query.fid));
    out.features.push_back(raw_feature(*feature, swap_axes));
    out.matching = 1;
    return out;
  }
  layer.ResetReading();
  while (query.limit < 0 || std::ssize(out.features) < query.limit) {
    const OGRFeatureUniquePtr feature(layer.GetNextFeature());
    if (!feature) break;
    out.features.push_back(raw_feature(*feature, swap_axes));
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
    throw bad_input(fmt::format("no feature of '{}' matches --where \"{}\"", file, query.where));
  throw bad_input(fmt::format("'{}' holds no features; give a file with field boundaries", file));
}

}  // namespace

RawDataset read_vector(const VectorQuery& query) {
  register_gdal_drivers();
  GdalMessages messages;
  const GDALDatasetUniquePtr dataset = open_one(query, messages);
  RawDataset out;
  out.file = shown_name(query.file);
  out.driver = dataset->GetDriverName();
  out.winding_matters = out.driver == "GeoJSON" || out.driver == "GeoJSONSeq";
  for (OGRLayer* layer : choose_layers(*dataset, query, out.skipped))
    out.layers.push_back(read_layer(*layer, query, messages));
  refuse_empty(out, query);
  return out;
}

}  // namespace tramline::io
