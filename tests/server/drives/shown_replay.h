#pragma once
// What the frames of a replay add up to.

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "server/served.h"
#include "server/work/drives.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::server {

using namespace testing_drives;

/// m², of GeoJSON coordinates of a MultiPolygon.
inline double area_of_json(const ordered_json& polygons) {
  const FrameProjection projection(frame_here());
  Region region;
  for (const ordered_json& polygon : polygons) {
    Polygon out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      Ring ring;
      for (const ordered_json& at : polygon[i]) ring.push_back(*projection.from_lonlat({at[0], at[1]}));
      ring.pop_back();
      if (i == 0)
        out.outer = ring;
      else
        out.holes.push_back(ring);
    }
    region.push_back(out);
  }
  return area(region);
}

/// What the frames of a stream add up to.
struct Shown {
  std::map<std::string, ordered_json> tiles{};
  ordered_json end{};
  int frames = 0;
  double first_s = 0;
  bool first_is_all = false;

  bool take(const std::string& name, const ordered_json& data) {
    if (name == "end") end = data.at("figures");
    if (name != "frame") return true;
    if (frames++ == 0) {
      first_s = data.at("time_s");
      first_is_all = data.at("all");
    }
    if (data.at("all")) tiles.clear();
    for (const ordered_json& tile : data.at("tiles")) tiles[tile.at("id")] = tile;
    return true;
  }
  double edges_m(const char* of) const {
    constexpr double kMetresPerDegree = 111320;
    double out = 0;
    for (const auto& [id, tile] : tiles)
      for (const ordered_json& polygon : tile.at(of))
        for (const ordered_json& ring : polygon)
          for (std::size_t i = 1; i < ring.size(); ++i)
            out += kMetresPerDegree * std::hypot((ring[i][0].get<double>() - ring[i - 1][0].get<double>()) *
                                                     std::cos(kLat * std::numbers::pi / 180),
                                                 ring[i][1].get<double>() - ring[i - 1][1].get<double>());
    return out;
  }
  double area_m2(const char* of) const {
    double out = 0;
    for (const auto& [id, tile] : tiles) out += area_of_json(tile.at(of));
    return out;
  }
};

}  // namespace tramline::server
