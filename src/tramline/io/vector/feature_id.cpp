#include "tramline/io/vector/feature_id.h"

#include <ogrsf_frmts.h>

#include <cctype>
#include <nlohmann/json.hpp>

namespace tramline::io {
namespace {

bool is_id(const char* name) {
  return std::tolower(static_cast<unsigned char>(name[0])) == 'i' &&
         std::tolower(static_cast<unsigned char>(name[1])) == 'd' && name[2] == '\0';
}

/// OGR turns whole-number GeoJSON ids into feature numbers; the original member tells them from counted ones.
std::string geojson_id(const OGRFeature& feature) {
  const char* text = feature.GetNativeData();
  if (text == nullptr) return {};
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("id")) return {};
  const auto& id = json["id"];
  return id.is_string() ? id.get<std::string>() : id.is_number() ? id.dump() : std::string{};
}

}  // namespace

std::string feature_id(const OGRFeature& feature) {
  for (int i = 0; i < feature.GetFieldCount(); ++i)
    if (is_id(feature.GetFieldDefnRef(i)->GetNameRef()) && feature.IsFieldSetAndNotNull(i)) {
      std::string value = feature.GetFieldAsString(i);
      if (!value.empty()) return value;
    }
  return geojson_id(feature);
}

}  // namespace tramline::io
