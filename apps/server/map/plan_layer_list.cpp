#include "server/map/plan_layer_list.h"

#include <optional>

#include "server/map/detour_layer.h"
#include "server/map/outside_layer.h"
#include "tramline/geometry/path/path.h"
#include "tramline/io/plan/plan_layers.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;
namespace layers = io::plan_layers;

ordered_json entry(const char* name, const char* title, std::size_t features, std::optional<double> m2,
                   std::optional<double> m = std::nullopt) {
  ordered_json out{{"name", name}, {"title", title}, {"features", features}, {"m2", nullptr}, {"m", nullptr}};
  if (m2) out["m2"] = *m2;
  if (m) out["m"] = *m;
  return out;
}

ordered_json entry(const char* name, const char* title, const Region& region) {
  return entry(name, title, region.size(), area(region));
}

double obstacle_area(const Field& field) {
  double sum = 0;
  for (const Obstacle& obstacle : field.obstacles) sum += area(obstacle.shape);
  return sum;
}

double subfield_area(const Plan& plan) {
  double sum = 0;
  for (const Subfield& subfield : plan.subfields) sum += area(subfield.shape);
  return sum;
}

double dropped_length(const Plan& plan) {
  double sum = 0;
  for (const DroppedPiece& piece : plan.dropped) sum += distance(piece.start, piece.end);
  return sum;
}

}  // namespace

ordered_json layer_list(const Plan& plan) {
  const Tally& tally = plan.tally;
  ordered_json out = ordered_json::array();
  out.push_back(entry(layers::kField, "Field", 1, area(Polygon{plan.field.outer, {}})));
  out.push_back(entry(layers::kBody, "Land to work", plan.body));
  if (!plan.worked.empty()) out.push_back(entry(layers::kWorked, "Worked before", plan.worked));
  out.push_back(entry(layers::kSubfields, "Subfields", plan.subfields.size(), subfield_area(plan)));
  out.push_back(entry(layers::kHeadland, "Headland", plan.headland.ground));
  out.push_back(
      entry(layers::kObstacles, "Obstacles", plan.field.obstacles.size(), obstacle_area(plan.field)));
  out.push_back(entry(layers::kSwaths, "Swaths", plan.pieces.size(), tally.worked_m2));
  out.push_back(entry(layers::kGivenUp, "Given up", plan.given_up));
  // The figures of the plan: ground worked three times counts twice, which no area of a region can say.
  out.push_back(entry(layers::kOverlap, "Overlap", plan.overlap.size(), tally.overlap_m2));
  out.push_back(outside_entry(plan));
  out.push_back(entry(layers::kUncovered, "Uncovered", plan.uncovered.size(), tally.uncovered_m2));
  out.push_back(entry(layers::kHeadlandUnworked, "Headland left out", plan.headland.unworked.size(),
                      plan.headland.uncovered_m2));
  out.push_back(entry(layers::kHeadlandPasses, "Headland passes", plan.headland.passes.size(),
                      plan.headland.worked_m2, length(plan.headland)));
  out.push_back(entry(layers::kTracks, "Tracks", plan.pieces.size(), std::nullopt, tally.track_length_m));
  if (plan.route.planned())
    out.push_back(entry(layers::kRouteLegs, "Route", plan.route.legs.size(), std::nullopt,
                        sums_of(plan.route).length_m));
  out.push_back(detour_entry(plan));
  out.push_back(
      entry(layers::kDropped, "Not worth driving", plan.dropped.size(), std::nullopt, dropped_length(plan)));
  out.push_back(entry(layers::kEncounters, "Meetings with obstacles", plan.encounters.size(), std::nullopt));
  return out;
}

}  // namespace tramline::server
