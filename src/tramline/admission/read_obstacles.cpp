#include "tramline/admission/read_obstacles.h"

#include <fmt/format.h>

#include "tramline/admission/project_rings.h"
#include "tramline/admission/zone_prefix.h"
#include "tramline/geometry/error.h"

namespace tramline {
namespace {

std::string file_name(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

/// Brings every point of a feature to longitude and latitude, or checks plain ones.
class Reader {
 public:
  Reader(const Crs& crs, std::string subject) : crs_(crs), subject_(std::move(subject)) {}

  Point operator()(Point input) {
    ++vertex_;
    const std::string fault = coordinate_fault(input, crs_);
    if (!fault.empty()) throw bad_input(fmt::format("{}: vertex {} {}", subject_, vertex_, fault));
    if (crs_.plain()) return input;
    const std::optional<Point> lonlat = crs_.to_lonlat(input);
    if (!lonlat)
      throw bad_input(fmt::format("{}: vertex {} ({:.10g}, {:.10g}) lies outside {}; correct the file's CRS",
                                  subject_, vertex_, input.x, input.y, crs_.name()));
    return *lonlat;
  }

 private:
  const Crs& crs_;
  std::string subject_;
  int vertex_ = 0;
};

LooseObstacle read_one(RawFeature feature, const Crs& crs, ObstacleKind kind, const std::string& origin) {
  const auto prefix = zone_prefix_m(feature, crs, origin);
  if (prefix) feature = without_prefix(std::move(feature), *prefix);
  LooseObstacle out{
      origin, kind, std::move(feature.polygons), std::move(feature.lines), std::move(feature.points), {}};
  Reader read(crs, origin);
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
    throw bad_input(fmt::format("{}: the feature has no geometry; remove it or draw the obstacle", origin));
  return out;
}

}  // namespace

std::vector<LooseObstacle> read_obstacles(const RawDataset& dataset, ObstacleKind kind, bool plain,
                                          const std::string& fallback_crs) {
  std::vector<LooseObstacle> out;
  const std::string file = file_name(dataset.file);
  for (const RawLayer& layer : dataset.layers) {
    const Crs crs = plain ? Crs() : Crs(layer.crs.empty() ? fallback_crs : layer.crs);
    if (plain && !layer.crs.empty() && Crs(layer.crs).in_degrees())
      throw bad_input(
          fmt::format("{}: the obstacles are in degrees but the field is in plain metres; give the field's "
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
