#include "tramline/io/vector/layer_reading.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <cctype>
#include <nlohmann/json.hpp>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/choose_layers.h"
#include "tramline/io/vector/flatten_geometry.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::io {
namespace {

bool is_id(const char* name) {
  return std::tolower(static_cast<unsigned char>(name[0])) == 'i' &&
         std::tolower(static_cast<unsigned char>(name[1])) == 'd' && name[2] == '\0';
}

/// OGR turns whole-number GeoJSON ids into feature numbers; the original member distinguishes them from
/// counted ones.
std::string geojson_id(const OGRFeature& feature) {
  const char* text = feature.GetNativeData();
  if (text == nullptr) return {};
  const auto native = nlohmann::json::parse(text, nullptr, false);
  if (!native.is_object() || !native.contains("id")) return {};
  const auto& id = native["id"];
  return id.is_string() ? id.get<std::string>() : id.is_number() ? id.dump() : std::string{};
}

/// The property called id (any case), or the GeoJSON member "id"; empty when the feature has neither.
std::string feature_id(const OGRFeature& feature) {
  for (int i = 0; i < feature.GetFieldCount(); ++i)
    if (is_id(feature.GetFieldDefnRef(i)->GetNameRef()) && feature.IsFieldSetAndNotNull(i)) {
      std::string value = feature.GetFieldAsString(i);
      if (!value.empty()) return value;
    }
  return geojson_id(feature);
}

void add_attributes(const OGRFeature& feature, const std::vector<std::string>& names, RawFeature& out) {
  for (const std::string& name : names) {
    const int index = feature.GetFieldIndex(name.c_str());  // OGR compares names whatever their case
    if (index >= 0 && feature.IsFieldSetAndNotNull(index))
      out.attributes[name] = feature.GetFieldAsString(index);
  }
}

void add_every_attribute(const OGRFeature& feature, RawFeature& out) {
  for (int i = 0; i < feature.GetFieldCount(); ++i)
    if (feature.IsFieldSetAndNotNull(i))
      out.attributes[feature.GetFieldDefnRef(i)->GetNameRef()] = feature.GetFieldAsString(i);
}

}  // namespace

RawFeature raw_feature(const OGRFeature& feature, AxisOrder axes, const VectorQuery& query) {
  RawFeature out;
  out.fid = feature.GetFID();
  out.id = feature_id(feature);
  if (query.every_attribute)
    add_every_attribute(feature, out);
  else
    add_attributes(feature, query.attributes, out);
  flatten_geometry(feature.GetGeometryRef(), axes, out);
  return out;
}

namespace {

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
  return bad_input(fmt::format("{} \"{}\" is not a filter for {}, whose attributes are {}: {}",
                               where_option(query), query.where, place, attribute_list(layer),
                               messages.last()));
}

}  // namespace

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

std::string place_of(OGRLayer& layer, const VectorQuery& query) {
  return fmt::format("layer '{}' of '{}'", layer.GetName(), shown_name(query.file));
}

RawLayer bare_layer(OGRLayer& layer, const VectorQuery& query) {
  return {layer.GetName(),
          OGRGeometryTypeToName(wkbFlatten(layer.GetGeomType())),
          layer_crs(layer.GetSpatialRef(), place_of(layer, query)),
          {},
          0};
}

RawDataset bare_dataset(GDALDataset& dataset, const VectorQuery& query) {
  RawDataset out;
  out.file = shown_name(query.file);
  out.driver = dataset.GetDriverName();
  const bool rfc_7946 = out.driver == "GeoJSON" || out.driver == "GeoJSONSeq";
  out.winding = rfc_7946 ? RingWinding::kPrescribed : RingWinding::kFree;
  return out;
}

}  // namespace tramline::io
