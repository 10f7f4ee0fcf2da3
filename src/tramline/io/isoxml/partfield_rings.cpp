#include "tramline/io/isoxml/partfield_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "tramline/geometry/polygon/region.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/places.h"

namespace tramline::io {
namespace {

constexpr std::string_view kBoundary = "1", kMainField = "9", kExterior = "1", kInterior = "2";

bool is_obstacle(std::string_view type) { return type == "3" || type == "4" || type == "6"; }

/// The points of a line string as a ring; nullopt where one of them is not a point.
std::optional<RawRing> ring_of(const pugi::xml_node& line, std::string& fault) {
  auto points = points_of(line, "a ring", fault);
  if (!points) return std::nullopt;
  RawRing out{*std::move(points)};
  out.closed = out.points.size() > 1 && out.points.front() == out.points.back();
  if (out.closed) out.points.pop_back();
  if (out.points.size() < 3) {
    fault = "a ring has fewer than three points";
    return std::nullopt;
  }
  return out;
}

bool inside(const RawRing& ring, Point at) {
  bool out = false;
  for (std::size_t i = 0, j = ring.points.size() - 1; i < ring.points.size(); j = i++) {
    const Point a = ring.points[i], b = ring.points[j];
    if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)) out = !out;
  }
  return out;
}

/// The polygons of one PLN; nullopt where a ring cannot be read.
std::optional<std::vector<RawPolygon>> polygons_of(const pugi::xml_node& polygon, std::string& fault) {
  std::vector<RawPolygon> out;
  std::vector<RawRing> holes;
  for (const pugi::xml_node line : polygon.children("LSG")) {
    const std::string_view type = line.attribute("A").value();
    if (type != kExterior && type != kInterior) continue;
    auto ring = ring_of(line, fault);
    if (!ring) return std::nullopt;
    if (type == kExterior)
      out.push_back({{std::move(*ring)}});
    else
      holes.push_back(std::move(*ring));
  }
  if (out.empty()) {
    fault = "it has no exterior ring";
    return std::nullopt;
  }
  for (RawRing& hole : holes) {
    const auto around = std::find_if(out.begin(), out.end(), [&](const RawPolygon& candidate) {
      return inside(candidate.rings.front(), hole.points.front());
    });
    (around == out.end() ? out.front() : *around).rings.push_back(std::move(hole));
  }
  return out;
}

RawFeature feature_of(const RawLayer& layer, const std::string& id) {
  RawFeature out;
  out.fid = std::ssize(layer.features) + 1;
  out.id = id;
  out.geometry_type = "Polygon";
  return out;
}

}  // namespace

std::optional<std::vector<Point>> points_of(const pugi::xml_node& line, const char* what,
                                            std::string& fault) {
  std::vector<Point> out;
  for (const pugi::xml_node point : line.children("PNT")) {
    const auto lat = number_in(point.attribute("C").value()), lon = number_in(point.attribute("D").value());
    const std::string wrong = lat && lon ? fault_of_lonlat({*lon, *lat}) : "no position";
    if (!wrong.empty()) {
      fault = fmt::format("point {} of {}: {}", out.size() + 1, what, wrong);
      return std::nullopt;
    }
    out.push_back({*lon, *lat});
  }
  return out;
}

RawDataset empty_partfields(const std::string& file) {
  RawDataset out;
  out.file = file;
  out.driver = "ISOXML";
  out.layers = {{"partfields", "Polygon", "EPSG:4326", {}, 0}, {"obstacles", "Polygon", "EPSG:4326", {}, 0}};
  return out;
}

void add_partfield(const pugi::xml_node& partfield, const std::string& file, RawDataset& dataset) {
  RawLayer& fields = dataset.layers[0];
  RawLayer& obstacles = dataset.layers[1];
  const std::string id = partfield.attribute("A").value();
  RawFeature boundary = feature_of(fields, id);
  for (const auto& [key, name] : {std::pair{"B", "code"}, std::pair{"C", "designator"}})
    if (const std::string value = partfield.attribute(key).value(); !value.empty())
      boundary.attributes[name] = value;
  bool whole = true;
  for (const pugi::xml_node polygon : partfield.children("PLN")) {
    const std::string_view type = polygon.attribute("A").value();
    const bool is_boundary = type == kBoundary || type == kMainField;
    if (!is_boundary && !is_obstacle(type)) continue;
    std::string fault;
    auto polygons = polygons_of(polygon, fault);
    if (!polygons) {
      dataset.skipped.push_back(
          {fmt::format("{} of partfield {}", is_boundary ? "boundary" : "obstacle", id), file, fault});
      whole = whole && !is_boundary;
      continue;
    }
    RawFeature obstacle = feature_of(obstacles, id);
    obstacle.attributes = boundary.attributes;
    RawFeature& target = is_boundary ? boundary : obstacle;
    for (RawPolygon& part : *polygons) target.polygons.push_back(std::move(part));
    if (!is_boundary) obstacles.features.push_back(std::move(obstacle));
  }
  if (boundary.polygons.size() > 1) boundary.geometry_type = "Multi Polygon";
  if (whole && !boundary.polygons.empty())
    fields.features.push_back(std::move(boundary));
  else if (whole)
    dataset.skipped.push_back({"partfield " + id, file, "it has no boundary"});
  else
    dataset.skipped.push_back({"partfield " + id, file, "part of its boundary cannot be read"});
}

}  // namespace tramline::io
