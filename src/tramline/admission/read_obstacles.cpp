#include "tramline/admission/read_obstacles.h"

#include <fmt/format.h>

#include "tramline/admission/lonlat_reader.h"
#include "tramline/admission/zone_prefix.h"
#include "tramline/geometry/error.h"

namespace tramline {
namespace {

LooseObstacle read_one(RawFeature feature, const Crs& crs, ObstacleKind kind, const std::string& origin) {
  const auto prefix = zone_prefix_m(feature, crs, origin);
  if (prefix) feature = without_prefix(std::move(feature), *prefix);
  LooseObstacle out{
      origin, kind, std::move(feature.polygons), std::move(feature.lines), std::move(feature.points), {}};
  LonlatReader read(crs, origin);
  const auto take = [&](Point& p) {
    p = read(p);
    out.bounds.extend(p);
  };
  for (RawPolygon& polygon : out.polygons)
    for (RawRing& ring : polygon.rings)
      for (Point& p : ring.points) take(p);
  for (auto& line : out.lines)
    for (Point& p : line) take(p);
  for (Point& p : out.points) take(p);
  if (out.bounds.empty())
    throw bad_input(fmt::format("{}: the feature has no geometry; remove it or draw it", origin));
  return out;
}

}  // namespace

std::vector<LooseObstacle> read_obstacles(const RawDataset& dataset, ObstacleKind kind,
                                          const std::string& fields_crs) {
  const bool plain = Crs(fields_crs).plain();
  std::vector<LooseObstacle> out;
  const std::string file = file_name(dataset.file);
  for (const RawLayer& layer : dataset.layers) {
    const Crs crs = plain ? Crs() : Crs(layer.crs.empty() ? fields_crs : layer.crs);
    if (plain && !layer.crs.empty() && Crs(layer.crs).in_degrees())
      throw bad_input(
          fmt::format("{}: the shapes are in degrees but the field is in plain metres; give the field's "
                      "CRS with --crs",
                      dataset.file));
    for (const RawFeature& feature : layer.features) {
      const std::string name = feature.id.empty() ? std::to_string(feature.fid) : feature.id;
      const std::string origin = dataset.layers.size() > 1
                                     ? fmt::format("{} {} feature {}", file, layer.name, name)
                                     : fmt::format("{} feature {}", file, name);
      out.push_back(read_one(feature, crs, kind, origin));
    }
  }
  return out;
}

}  // namespace tramline
