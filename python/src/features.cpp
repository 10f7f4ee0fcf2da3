#include "features.h"

#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/read_geometry.h"

namespace tramline::python {
namespace {

io::GeometryForm form_named(const std::string& word) {
  if (word == "wkb") return io::GeometryForm::kWkb;
  return word == "wkt" ? io::GeometryForm::kWkt : io::GeometryForm::kGeoJson;
}

}  // namespace

std::shared_ptr<RawDataset> features_of(const std::vector<GivenGeometry>& geometries, const std::string& crs,
                                        const std::string& name) {
  if (geometries.empty()) throw bad_input("the " + name + " is empty");
  auto out = std::make_shared<RawDataset>();
  out->file = name;
  out->driver = "memory";
  RawLayer layer;
  layer.name = name;
  layer.geometry_type = "Unknown";
  layer.crs = crs;
  for (const auto& [bytes, form, id] : geometries) {
    RawFeature feature = io::read_geometry(bytes, form_named(form));
    feature.fid = static_cast<long long>(layer.features.size());
    feature.id = id;
    layer.features.push_back(std::move(feature));
  }
  layer.matching = static_cast<long long>(layer.features.size());
  out->layers.push_back(std::move(layer));
  return out;
}

}  // namespace tramline::python
