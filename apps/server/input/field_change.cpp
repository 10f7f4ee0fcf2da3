#include "server/input/field_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "request/field_input.h"
#include "server/input/drawn_shape.h"
#include "server/input/geometry_input.h"
#include "server/input/json_input.h"
#include "server/map/shown_place.h"
#include "tramline/admission/admit.h"
#include "tramline/admission/read_obstacles.h"
#include "tramline/geodesy/crs.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

constexpr double kLeastSize_m = 0.01, kMostSize_m = 1000;

void remove_obstacles(Field& field, const ordered_json& numbers) {
  std::set<std::size_t> going;
  for (const ordered_json& number : numbers) {
    const bool known = number.is_number_integer() && number.get<long long>() >= 1 &&
                       number.get<long long>() <= std::ssize(field.obstacles);
    if (!known)
      throw bad_input(fmt::format("remove names obstacle {}, but the field has {}", number.dump(),
                                  field.obstacles.size()));
    going.insert(number.get<std::size_t>() - 1);
  }
  std::vector<Obstacle> left;
  for (std::size_t i = 0; i < field.obstacles.size(); ++i)
    if (!going.contains(i)) left.push_back(std::move(field.obstacles[i]));
  field.obstacles = std::move(left);
}

ObstacleKind kind_in(const JsonInput& input) {
  const std::string kind = input.text("kind");
  if (kind == "obstacle") return ObstacleKind::kObstacle;
  if (kind == "passable") return ObstacleKind::kPassable;
  throw bad_input(
      fmt::format("{} is '{}', but has to be obstacle or passable", input.place_of("kind"), kind));
}

/// One that no obstacle has yet.
std::string next_origin(const Field& field) {
  for (int number = 1;; ++number) {
    std::string origin = fmt::format("drawn {}", number);
    // United obstacles carry the names of all.
    if (std::none_of(field.obstacles.begin(), field.obstacles.end(), [&](const Obstacle& obstacle) {
          return obstacle.origin.find(origin) != std::string::npos;
        }))
      return origin;
  }
}

void add_obstacle(Field& field, const ordered_json& json, std::size_t number) {
  const std::string place = fmt::format("add {}", number);
  const JsonInput input(json, place, {"kind", "geometry", "size_m"});
  LooseObstacle obstacle = drawn_shape(raw_feature_in(input.value("geometry"), input.place_of("geometry")),
                                       next_origin(field), field);
  obstacle.kind = kind_in(input);
  const double size_m = input.number_if("size_m").value_or(app::FieldOptions{}.obstacle_size_m);
  if (!(size_m >= kLeastSize_m && size_m <= kMostSize_m))
    throw bad_input(fmt::format("{} has to lie between {} and {} m", input.place_of("size_m"), kLeastSize_m,
                                kMostSize_m));
  std::vector<char> met(1, 0);
  place_obstacles(field, {obstacle}, size_m, met);
  if (met[0] == 0)
    throw bad_input(
        fmt::format("the shape drawn as obstacle {} does not reach the field; draw it inside", number));
}

/// A place of the map, or one in the field's metres, in the coordinates of the field's input.
class InputPlace {
 public:
  explicit InputPlace(const LocalFrame& frame)
      : plain_(!frame.geodetic), origin_{frame.origin_x_m, frame.origin_y_m}, place_(frame) {}

  Point of_map(Point lonlat) const { return plain_ ? place_.to_local(lonlat) + origin_ : lonlat; }
  Point of_field(Point local_m) const { return plain_ ? local_m + origin_ : place_.to_lonlat(local_m); }

 private:
  bool plain_;
  Point origin_;
  ShownPlace place_;
};

LooseObstacle loose(const Obstacle& obstacle, const InputPlace& place) {
  LooseObstacle out{obstacle.origin, obstacle.kind, {}, {}, {}, {}};
  const auto ring_of = [&](const Ring& ring) {
    RawRing raw;
    for (const Point p : ring) {
      raw.points.push_back(place.of_field(p));
      out.bounds.extend(raw.points.back());
    }
    return raw;
  };
  RawPolygon polygon{{ring_of(obstacle.shape.outer)}};
  for (const Ring& hole : obstacle.shape.holes) polygon.rings.push_back(ring_of(hole));
  out.polygons.push_back(std::move(polygon));
  return out;
}

}  // namespace

Field with_boundary(const Field& field, const ordered_json& boundary) {
  RawFeature feature = raw_feature_in(boundary, "boundary");
  if (feature.polygons.size() != 1) throw bad_input("boundary has to be one polygon");
  const InputPlace place(field.frame);
  for (RawRing& ring : feature.polygons.front().rings)
    for (Point& p : ring.points) p = place.of_map(p);
  feature.id = field.id;
  feature.fid = 1;
  const Crs crs = field.frame.geodetic ? Crs("OGC:CRS84") : Crs();
  Admission admission = admit(feature, {"the drawing", "drawn", &crs});
  if (admission.fields.size() != 1)
    throw bad_input("the boundary crosses itself so that it bounds several fields; draw each by itself");
  Field out = std::move(admission.fields.front());
  out.source.input_crs = crs.definition();
  std::vector<LooseObstacle> obstacles;
  for (const Obstacle& obstacle : field.obstacles) obstacles.push_back(loose(obstacle, place));
  std::vector<char> met(obstacles.size(), 0);
  if (!obstacles.empty()) place_obstacles(out, obstacles, app::FieldOptions{}.obstacle_size_m, met);
  return out;
}

Field changed_field(Field field, const ordered_json& remove, const ordered_json& add) {
  remove_obstacles(field, remove);
  std::size_t number = 0;
  for (const ordered_json& item : add) add_obstacle(field, item, ++number);
  return field;
}

}  // namespace tramline::server
