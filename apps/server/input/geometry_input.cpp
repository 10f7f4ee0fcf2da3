#include "server/input/geometry_input.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "server/input/json_input.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

const ordered_json& list_of(const ordered_json& json, const std::string& place) {
  if (!json.is_array() || json.empty())
    throw bad_input(fmt::format("{}.coordinates has to be a list that is not empty", place));
  return json;
}

RawRing ring_in(const ordered_json& json, const std::string& place) {
  RawRing out{positions_of(json, place + ".coordinates"), false};
  if (out.points.size() > 1 && out.points.front() == out.points.back()) {
    out.points.pop_back();
    out.closed = true;
  }
  return out;
}

RawPolygon polygon_in(const ordered_json& json, const std::string& place) {
  RawPolygon out;
  for (const ordered_json& ring : list_of(json, place)) out.rings.push_back(ring_in(ring, place));
  return out;
}

}  // namespace

RawFeature raw_feature_in(const ordered_json& geometry, const std::string& place) {
  const JsonInput input(geometry, place, {"type", "coordinates"});
  const ordered_json& coordinates = input.value("coordinates");
  RawFeature out;
  out.geometry_type = input.text("type");
  if (out.geometry_type == "Point")
    out.points.push_back(position_of(coordinates, place + ".coordinates"));
  else if (out.geometry_type == "MultiPoint")
    out.points = positions_of(coordinates, place + ".coordinates");
  else if (out.geometry_type == "LineString")
    out.lines.push_back(positions_of(coordinates, place + ".coordinates"));
  else if (out.geometry_type == "MultiLineString")
    for (const ordered_json& line : list_of(coordinates, place))
      out.lines.push_back(positions_of(line, place + ".coordinates"));
  else if (out.geometry_type == "Polygon")
    out.polygons.push_back(polygon_in(coordinates, place));
  else if (out.geometry_type == "MultiPolygon")
    for (const ordered_json& polygon : list_of(coordinates, place))
      out.polygons.push_back(polygon_in(polygon, place));
  else
    throw bad_input(
        fmt::format("{}.type is '{}'; draw a point, a line or a polygon", place, out.geometry_type));
  return out;
}

}  // namespace tramline::server
