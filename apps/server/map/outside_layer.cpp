#include "server/map/outside_layer.h"

#include "server/map/few_corners.h"
#include "server/map/shown_place.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::server {

using nlohmann::ordered_json;

Region land_outside(const Plan& plan) {
  if (plan.overlap.empty()) return {};
  return difference(plan.overlap, {{plan.field.outer, {}}});
}

ordered_json outside_entry(const Plan& plan) {
  const Region land = land_outside(plan);
  return {{"name", kOutsideLayer},
          {"title", "Worked outside"},
          {"features", land.size()},
          {"m2", area(land)},
          {"m", nullptr}};
}

ordered_json outside_geojson(const Plan& plan, double detail_m) {
  const ShownPlace place(plan.field.frame);
  ordered_json features = ordered_json::array();
  for (const Polygon& polygon : land_outside(plan))
    features.push_back(feature_json("Polygon", place.polygon(thinned_polygon(polygon, detail_m)),
                                    {{"area_m2", area(polygon)}}));
  return collection_json(std::move(features));
}

}  // namespace tramline::server
