#include "server/uploads/survey_register.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "server/map/few_corners.h"
#include "server/uploads/feature_name.h"
#include "tramline/geodesy/crs.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/io/land/read_fields.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// Of a shape that is a few pixels wide, as a share of its size.
constexpr double kFewCorners = 1.0 / 60;
constexpr double kMetresPerDegree = 111'320;
constexpr double kDegreesWritten = 1e6;  // 0.1 m

/// Longitude and latitude of the corners that tell, the first once more at the end; none where there are
/// fewer than three, or a place is unknown; plain metres are shown about (0°, 0°).
std::vector<Point> shown_ring(const RawRing& ring, const Crs& crs) {
  if (ring.points.size() < 3) return {};
  std::vector<Point> out;
  for (const Point at : few_corners(ring.points, kFewCorners)) {
    const std::optional<Point> lonlat =
        crs.plain() ? Point{at.x / kMetresPerDegree, at.y / kMetresPerDegree} : crs.to_lonlat(at);
    if (!lonlat) return {};
    out.push_back(*lonlat);
  }
  if (out.front() != out.back()) out.push_back(out.front());
  return out;
}

/// About the area of a ring, m²: whatever the unit of its CRS, by its places. 0 where it has none.
double area_about_m2(const RawRing& ring, const Crs& crs) {
  if (ring.points.size() < 3) return 0;
  if (crs.plain()) return std::abs(signed_area(ring.points));
  Ring places;
  for (const Point p : ring.points) {
    const std::optional<Point> lonlat = crs.to_lonlat(p);
    if (!lonlat) return 0;
    places.push_back(*lonlat);
  }
  const double lat = places.front().y * std::numbers::pi / 180;
  return std::abs(signed_area(places)) * kMetresPerDegree * kMetresPerDegree * std::cos(lat);
}

ordered_json coordinates(const std::vector<Point>& ring) {
  ordered_json out = ordered_json::array();
  for (const Point p : ring)
    out.push_back({std::round(p.x * kDegreesWritten) / kDegreesWritten,
                   std::round(p.y * kDegreesWritten) / kDegreesWritten});
  return out;
}

/// nullopt for a feature that is no area.
std::optional<ordered_json> candidate_of(const RawFeature& feature, const Crs& crs) {
  ordered_json shapes = ordered_json::array();
  double area_m2 = 0;
  std::size_t holes = 0;
  for (const RawPolygon& polygon : feature.polygons) {
    if (polygon.rings.empty()) continue;
    const std::vector<Point> ring = shown_ring(polygon.rings.front(), crs);
    if (ring.size() >= 4) shapes.push_back({coordinates(ring)});
    area_m2 += area_about_m2(polygon.rings.front(), crs);
    for (std::size_t i = 1; i < polygon.rings.size(); ++i, ++holes)
      area_m2 -= area_about_m2(polygon.rings[i], crs);
  }
  if (shapes.empty()) return std::nullopt;
  return ordered_json{{"area_m2", std::round(area_m2)},
                      {"obstacles", holes},
                      {"refused", nullptr},
                      {"rings", {{"type", "MultiPolygon"}, {"coordinates", std::move(shapes)}}}};
}

}  // namespace

ordered_json words_of(const Upload& upload, const std::string& layer, const RawFeature& feature,
                      std::size_t in_layer) {
  return {{"name", name_in_upload(upload, layer, feature, static_cast<long long>(in_layer))},
          {"crop", feature_crop(feature.attributes)},
          {"attributes", feature.attributes}};
}

void add_register(const Upload& upload, const std::string& layer, ordered_json& features) {
  io::VectorQuery query;
  query.file = upload.path.string();
  query.layer = layer;
  query.every_attribute = true;
  const RawDataset dataset = io::read_fields(query);
  const RawLayer& read = dataset.layers.front();
  const Crs crs(read.crs);
  for (const RawFeature& feature : read.features) {
    std::optional<ordered_json> candidate = candidate_of(feature, crs);
    if (!candidate) continue;
    ordered_json entry{{"fid", feature.fid}, {"layer", layer}, {"id", feature.id}};
    entry.update(*candidate);
    entry.update(words_of(upload, layer, feature, read.features.size()));
    features.push_back(std::move(entry));
  }
}

}  // namespace tramline::server
