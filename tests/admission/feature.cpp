#include "admission/feature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::testing_features {

RawRing ring(const std::string& text) {
  RawRing out;
  std::istringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ',');) {
    // std::stod reads "nan" and "inf", which streams do not.
    std::istringstream words(pair);
    std::string x, y;
    words >> x >> y;
    out.points.push_back({std::stod(x), std::stod(y)});
  }
  out.closed = out.points.size() > 1 && out.points.front() == out.points.back();
  if (out.closed) out.points.pop_back();
  return out;
}

RawPolygon polygon(const std::vector<std::string>& rings) {
  RawPolygon out;
  for (const std::string& text : rings) out.rings.push_back(ring(text));
  return out;
}

RawFeature feature(const std::vector<std::vector<std::string>>& polygons) {
  RawFeature out;
  out.fid = 7;
  out.geometry_type = polygons.size() > 1 ? "Multi Polygon" : "Polygon";
  for (const auto& rings : polygons) out.polygons.push_back(polygon(rings));
  return out;
}

Admission admit_plain(const RawFeature& feature, RingWinding winding) {
  const Crs plain;
  return admit(feature, {"farm.gpkg", "parcels", &plain, winding});
}

Field admit_one(const std::vector<std::string>& rings) {
  Admission admission = admit_plain(feature({rings}));
  EXPECT_EQ(admission.fields.size(), 1u);
  expect_admissible(admission.fields.front());
  return admission.fields.front();
}

double workable_m2(const Field& field) {
  double sum = signed_area(field.outer);
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kObstacle) sum -= area(obstacle.shape);
  return sum;
}

double changes_m2(const Field& field) {
  double sum = 0;
  for (const Repair& repair : field.repairs) sum += repair.area_change_m2;
  return sum;
}

double drawn_m2(const RawFeature& feature) {
  double sum = 0;
  for (const RawPolygon& part : feature.polygons)
    for (std::size_t r = 0; r < part.rings.size(); ++r)
      sum += (r == 0 ? 1 : -1) * std::abs(signed_area(part.rings[r].points));
  return sum;
}

void expect_admissible(const Field& field) {
  const Region inside = {{field.outer, {}}};
  EXPECT_GT(signed_area(field.outer), 0) << field.id;
  EXPECT_FALSE(find_invalidity({field.outer, {}})) << field.id;
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
    const Region shape = {field.obstacles[i].shape};
    EXPECT_FALSE(find_invalidity(shape[0])) << field.id << " " << field.obstacles[i].origin;
    EXPECT_LE(area(difference(shape, inside)), 1e-3) << field.id << " " << field.obstacles[i].origin;
    for (std::size_t j = 0; j < i; ++j)
      if (intersects(bounds(shape), bounds(field.obstacles[j].shape))) {
        EXPECT_LE(area(intersection(shape, {field.obstacles[j].shape})), 1e-3) << field.id;
      }
  }
}

std::string refusal(const RawFeature& feature, const AdmissionContext& context) {
  try {
    admit(feature, context);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

std::string refusal_plain(const std::vector<std::string>& rings) {
  const Crs plain;
  return refusal(feature({rings}), {"farm.gpkg", "parcels", &plain});
}

}  // namespace tramline::testing_features
