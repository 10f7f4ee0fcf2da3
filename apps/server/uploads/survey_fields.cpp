#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "request/field_input.h"
#include "server/http/page_words.h"
#include "server/map/shown_place.h"
#include "server/uploads/survey.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/simplified_line.h"
#include "tramline/io/isoxml/read_fields.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// More are not for choosing from a list.
constexpr long long kMostListed = 500;
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

Ring simpler(Ring ring) {
  const Box box = bounds(ring);
  ring.push_back(ring.front());
  Ring out;
  for (const std::size_t i : simplified_line(ring, kFineness * std::max(box.width(), box.height())))
    out.push_back(ring[i]);
  out.pop_back();
  return out.size() < 3 ? Ring(ring.begin(), ring.end() - 1) : out;
}

/// All parts of one feature.
struct Candidate {
  std::string id;
  double area_m2 = 0;
  std::size_t obstacles = 0;
  ordered_json refused;
  ordered_json shapes = ordered_json::array();
};

std::map<long long, Candidate> candidates_in(const app::FieldInput& input, const Upload& upload) {
  std::map<long long, Candidate> out;
  for (const Field& field : input.fields) {
    Candidate& candidate = out[field.source.fid];
    if (candidate.id.empty()) candidate.id = field.id;
    candidate.area_m2 += area_m2(field);
    candidate.obstacles += field.obstacles.size();
    const ShownPlace place(field.frame);
    candidate.shapes.push_back(place.polygon({simpler(field.outer), {}}));
  }
  for (const app::Refusal& refusal : input.refusals) {
    Candidate& candidate = out[refusal.fid];
    candidate.id = refusal.field_id;
    candidate.refused = upload.in_its_name(in_page_words(refusal.sentence));
  }
  return out;
}

}  // namespace

ordered_json survey_fields_of(const Upload& upload) {
  ordered_json features = ordered_json::array();
  long long total = 0;
  const std::vector<std::string> layers = layers_with_polygons(upload);
  if (layers.empty()) throw bad_input("there are no polygons in it");
  for (const std::string& layer : layers) {
    app::FieldOptions options;
    options.file = upload.path.string();
    options.layer = layer;
    const app::FieldInput input = app::survey_fields(options, kMostListed);
    total += input.features;
    for (auto& [fid, candidate] : candidates_in(input, upload))
      features.push_back(
          {{"fid", fid},
           {"layer", layer},
           {"id", id_in_its_name(upload, candidate.id)},
           {"area_m2", candidate.area_m2},
           {"obstacles", candidate.obstacles},
           {"refused", candidate.refused},
           {"rings", {{"type", "MultiPolygon"}, {"coordinates", std::move(candidate.shapes)}}}});
  }
  if (features.empty()) throw bad_input("there are no polygons in it");
  return {{"features", std::move(features)}, {"features_total", total}};
}

}  // namespace tramline::server
