#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "request/field_input.h"
#include "server/http/page_words.h"
#include "server/map/few_corners.h"
#include "server/map/shown_place.h"
#include "server/uploads/feature_name.h"
#include "server/uploads/survey.h"
#include "server/uploads/survey_register.h"
#include "tramline/geometry/error.h"
#include "tramline/io/land/read_fields.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// Of files with more, whether each can be planned shows when it is stored.
constexpr long long kMostAdmitted = 500;
/// Of a picture of a few pixels, as a share of its size.
constexpr double kFineness = 1.0 / 150;

bool may_hold_polygons(const std::string& geometry_type) {
  return geometry_type.find("Polygon") != std::string::npos ||
         geometry_type.find("Unknown") != std::string::npos ||
         geometry_type.find("Collection") != std::string::npos ||
         geometry_type.find("Surface") != std::string::npos;
}

std::vector<std::string> layers_with_polygons(const Upload& upload) {
  io::VectorQuery query;
  query.file = upload.path.string();
  query.all_layers = true;
  query.limit = 1;
  std::vector<std::string> out;
  for (const RawLayer& layer : io::read_fields(query).layers) {
    const bool holds = std::any_of(layer.features.begin(), layer.features.end(),
                                   [](const RawFeature& feature) { return !feature.polygons.empty(); });
    // Those of a task set are obstacles of its fields.
    if ((may_hold_polygons(layer.geometry_type) || holds) && layer.name != "obstacles")
      out.push_back(layer.name);
  }
  return out;
}

/// All parts of one feature.
struct Candidate {
  std::string id;
  double area_m2 = 0;
  std::size_t obstacles = 0;
  ordered_json refused;
  ordered_json shapes = ordered_json::array();
};

std::map<long long, Candidate> candidates_in(const app::FieldInput& input) {
  std::map<long long, Candidate> out;
  for (const Field& field : input.fields) {
    Candidate& candidate = out[field.source.fid];
    if (candidate.id.empty()) candidate.id = field.id;
    candidate.area_m2 += area_m2(field);
    candidate.obstacles += field.obstacles.size();
    const ShownPlace place(field.frame);
    candidate.shapes.push_back(place.polygon({few_corners(field.outer, kFineness), {}}));
  }
  for (const app::Refusal& refusal : input.refusals) {
    Candidate& candidate = out[refusal.fid];
    candidate.id = refusal.field_id;
    candidate.refused = in_page_words(refusal.sentence);
  }
  return out;
}

/// Features by number, with all that their attributes say.
std::map<long long, RawFeature> attributes_in(const Upload& upload, const std::string& layer) {
  io::VectorQuery query;
  query.file = upload.path.string();
  query.layer = layer;
  query.every_attribute = true;
  std::map<long long, RawFeature> out;
  RawDataset dataset = io::read_fields(query);
  for (RawFeature& feature : dataset.layers.front().features) {
    feature.polygons.clear();
    out[feature.fid] = std::move(feature);
  }
  return out;
}

void add_admitted(const app::FieldInput& input, const Upload& upload, const std::string& layer,
                  ordered_json& features) {
  const std::map<long long, RawFeature> read = attributes_in(upload, layer);
  for (auto& [fid, candidate] : candidates_in(input)) {
    ordered_json entry{{"fid", fid},
                       {"layer", layer},
                       {"id", id_in_its_name(upload, candidate.id)},
                       {"area_m2", candidate.area_m2},
                       {"obstacles", candidate.obstacles},
                       {"refused", candidate.refused},
                       {"rings", {{"type", "MultiPolygon"}, {"coordinates", std::move(candidate.shapes)}}}};
    if (const auto feature = read.find(fid); feature != read.end())
      entry.update(words_of(upload, layer, feature->second, read.size()));
    if (candidate.refused.is_string())
      entry["refused"] = upload.in_its_name(with_name(candidate.refused, entry.value("name", candidate.id)));
    features.push_back(std::move(entry));
  }
}

}  // namespace

ordered_json survey_fields_of(const Upload& upload) {
  ordered_json features = ordered_json::array();
  const std::vector<std::string> layers = layers_with_polygons(upload);
  if (layers.empty()) throw bad_input("there are no polygons in it");
  for (const std::string& layer : layers) {
    app::FieldOptions options;
    options.file = upload.path.string();
    options.layer = layer;
    // One more tells whether there are too many.
    const app::FieldInput input = app::survey_fields(options, kMostAdmitted + 1);
    if (input.features > kMostAdmitted)
      add_register(upload, layer, features);
    else
      add_admitted(input, upload, layer, features);
  }
  if (features.empty()) throw bad_input("there are no polygons in it");
  const std::size_t total = features.size();
  return {{"features", std::move(features)}, {"features_total", total}};
}

}  // namespace tramline::server
