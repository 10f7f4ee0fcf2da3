#include "server/map/shown_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/export/layer_geojson.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// A hundredth of a millimetre; more digits are but longer.
double rounded(double degrees) { return std::round(degrees * 1e10) / 1e10; }

}  // namespace

ShownPlace::ShownPlace(const LocalFrame& frame) : projection_(io::shown_frame(frame)) {}

Point ShownPlace::to_local(Point lonlat) const {
  const bool on_the_globe = std::abs(lonlat.x) <= 180 && std::abs(lonlat.y) <= 90;
  const std::optional<Point> local = on_the_globe ? projection_.from_lonlat(lonlat) : std::nullopt;
  if (!local)
    throw bad_input(
        fmt::format("({:.7f}, {:.7f}) lies nowhere near the field; draw within the map of the field",
                    lonlat.x, lonlat.y));
  return *local;
}

ordered_json ShownPlace::position(Point local_m) const {
  const Point p = to_lonlat(local_m);
  return {rounded(p.x), rounded(p.y)};
}

ordered_json ShownPlace::line(const std::vector<Point>& points) const {
  ordered_json out = ordered_json::array();
  for (const Point p : points) out.push_back(position(p));
  return out;
}

ordered_json ShownPlace::polygon(const Polygon& polygon) const {
  ordered_json out = ordered_json::array();
  const auto add = [&](Ring ring) {
    ring.push_back(ring.front());
    out.push_back(line(ring));
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return out;
}

ordered_json ShownPlace::region(const Region& region) const {
  ordered_json out = ordered_json::array();
  for (const Polygon& part : region) out.push_back(polygon(part));
  return out;
}

ordered_json ShownPlace::bbox(const Box& box) const {
  Box out;
  for (const Point corner : {Point{box.min_x, box.min_y}, Point{box.max_x, box.min_y},
                             Point{box.max_x, box.max_y}, Point{box.min_x, box.max_y}})
    out.extend(to_lonlat(corner));
  return {rounded(out.min_x), rounded(out.min_y), rounded(out.max_x), rounded(out.max_y)};
}

ordered_json feature_json(const char* type, ordered_json coordinates, ordered_json properties) {
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}},
          {"properties", std::move(properties)}};
}

ordered_json collection_json(ordered_json features) {
  return {{"type", "FeatureCollection"}, {"features", std::move(features)}};
}

}  // namespace tramline::server
