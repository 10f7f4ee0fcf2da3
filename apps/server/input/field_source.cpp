#include "server/input/field_source.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "request/field_input.h"
#include "server/input/geometry_input.h"
#include "server/input/json_input.h"
#include "tramline/admission/admit.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

constexpr const char* kLonLat = "OGC:CRS84";

/// As the user calls the file, wherever it lies now.
void name_source(const Upload& upload, Field& field) {
  field.id = id_in_its_name(upload, field.id);
  field.source.file = upload.name;
  field.source.layer = id_in_its_name(upload, field.source.layer);
}

}  // namespace

NewFields fields_from(const Upload& upload, const FeatureChoice& choice) {
  app::FieldOptions options;
  options.file = upload.path.string();
  options.layer = choice.layer;
  options.fid = choice.fid;
  options.crs = choice.crs;
  if (choice.obstacles) options.obstacles_file = choice.obstacles->path.string();
  if (choice.obstacle_size_m) options.obstacle_size_m = *choice.obstacle_size_m;
  const auto in_their_names = [&](const std::string& text) {
    const std::string sentence = upload.in_its_name(text);
    return choice.obstacles ? choice.obstacles->in_its_name(sentence) : sentence;
  };
  try {
    app::FieldInput input = app::load_fields(options);
    for (Field& field : input.fields) {
      name_source(upload, field);
      if (choice.obstacles) field.source.obstacles_file = choice.obstacles->name;
      for (Obstacle& obstacle : field.obstacles) obstacle.origin = in_their_names(obstacle.origin);
    }
    for (Skipped& item : input.skipped) item.where = in_their_names(item.where);
    return {std::move(input.fields), std::move(input.skipped)};
  } catch (const Error& error) {
    throw Error(error.kind(), in_their_names(error.what()));
  }
}

NewFields fields_drawn(const nlohmann::ordered_json& geometry, const std::string& name) {
  RawFeature feature = raw_feature_in(geometry, "geometry");
  feature.id = name.empty() ? "drawn field" : name;
  feature.fid = 1;
  if (feature.polygons.empty()) throw bad_input("geometry has to be a polygon or a multipolygon");
  const Crs crs(kLonLat);
  Admission admission = admit(feature, {"the drawing", "drawn", &crs});
  for (Field& field : admission.fields) field.source.input_crs = crs.definition();
  return {std::move(admission.fields), std::move(admission.skipped)};
}

}  // namespace tramline::server
