#include "server/map/field_json.h"

#include <algorithm>

#include "report/report_parts.h"
#include "server/map/few_corners.h"
#include "server/map/shown_place.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

std::ptrdiff_t count(const Field& field, ObstacleKind kind) {
  return std::count_if(field.obstacles.begin(), field.obstacles.end(),
                       [&](const Obstacle& obstacle) { return obstacle.kind == kind; });
}

ordered_json shapes_of(const Field& field) {
  const ShownPlace place(field.frame);
  ordered_json features = ordered_json::array();
  features.push_back(
      feature_json("Polygon", place.polygon({field.outer, {}}),
                   {{"kind", "field"}, {"number", 0}, {"area_m2", area(Polygon{field.outer, {}})}}));
  int number = 0;
  for (const Obstacle& obstacle : field.obstacles)
    features.push_back(
        feature_json("Polygon", place.polygon(obstacle.shape),
                     {{"kind", obstacle.kind == ObstacleKind::kPassable ? "passable" : "obstacle"},
                      {"number", ++number},
                      {"origin", obstacle.origin},
                      {"area_m2", area(obstacle.shape)}}));
  return collection_json(std::move(features));
}

}  // namespace

ordered_json field_entry(const KeptField& kept) {
  const Field& field = kept.field;
  return {{"id", kept.id},
          {"name", kept.name},
          {"area_m2", area_m2(field)},
          {"obstacles", count(field, ObstacleKind::kObstacle)},
          {"passable", count(field, ObstacleKind::kPassable)},
          {"geodetic", field.frame.geodetic},
          {"bbox", ShownPlace(field.frame).bbox(bounds(field.outer))},
          {"created", kept.created},
          {"crop", kept.crop},
          {"tags", kept.tags},
          {"reshaped", kept.reshaped}};
}

ordered_json field_outline(const KeptField& kept) {
  // Of a shape that is a hundred pixels wide.
  constexpr double kFine = 1.0 / 200;
  const Ring outline = few_corners(kept.field.outer, kFine);
  return {{"type", "Polygon"}, {"coordinates", ShownPlace(kept.field.frame).polygon({outline, {}})}};
}

ordered_json field_in_full(const KeptField& kept) {
  ordered_json out = field_entry(kept);
  out["repairs"] = app::repairs_json(kept.field.repairs);
  out["skipped"] = app::skipped_json(kept.skipped);
  out["warnings"] = kept.field.warnings;
  out["shapes"] = shapes_of(kept.field);
  return out;
}

}  // namespace tramline::server
