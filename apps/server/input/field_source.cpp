#include "server/input/field_source.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "request/field_input.h"
#include "server/input/geometry_input.h"
#include "server/input/json_input.h"
#include "server/uploads/feature_name.h"
#include "tramline/admission/admit.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

constexpr const char* kLonLat = "OGC:CRS84";

void name_part(const std::string& name, Field& field) {
  field.id = field.source.part > 0 ? fmt::format("{} #{}", name, field.source.part + 1) : name;
}

/// As the user calls the feature and the file, wherever that lies now.
void name_source(const Upload& upload, const std::string& name, Field& field) {
  name_part(name, field);
  field.source.file = upload.name;
  field.source.layer = id_in_its_name(upload, field.source.layer);
}

std::string name_of_choice(const Upload& upload, const FeatureChoice& choice, const std::string& layer,
                           long long fid) {
  return choice.name.empty() ? name_in_upload(upload, layer, fid) : choice.name;
}

/// A sentence of admission, with the feature's name in it if that can be read.
std::string about_the_feature(const Upload& upload, const FeatureChoice& choice,
                              const std::string& sentence) {
  if (!choice.fid) return sentence;
  try {
    return with_name(sentence, name_of_choice(upload, choice, choice.layer, *choice.fid));
  } catch (const Error&) {
    return sentence;  // which says itself why the file cannot be read
  }
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
    const FieldSource& source = input.fields.front().source;
    const std::string name = name_of_choice(upload, choice, source.layer, source.fid);
    for (Field& field : input.fields) {
      name_source(upload, name, field);
      if (choice.obstacles) field.source.obstacles_file = choice.obstacles->name;
      for (Obstacle& obstacle : field.obstacles) obstacle.origin = in_their_names(obstacle.origin);
    }
    for (Skipped& item : input.skipped) item.where = in_their_names(item.where);
    return {std::move(input.fields), std::move(input.skipped)};
  } catch (const Error& error) {
    throw Error(error.kind(), in_their_names(about_the_feature(upload, choice, error.what())));
  }
}

NewFields fields_drawn(const nlohmann::ordered_json& geometry, const std::string& name) {
  RawFeature feature = raw_feature_in(geometry, "geometry");
  feature.id = name.empty() ? "Drawn field" : name;
  feature.fid = 1;
  if (feature.polygons.empty()) throw bad_input("geometry has to be a polygon or a multipolygon");
  const Crs crs(kLonLat);
  Admission admission = admit(feature, {"the drawing", "drawn", &crs});
  for (Field& field : admission.fields) {
    name_part(feature.id, field);
    field.source.input_crs = crs.definition();
  }
  return {std::move(admission.fields), std::move(admission.skipped)};
}

}  // namespace tramline::server
