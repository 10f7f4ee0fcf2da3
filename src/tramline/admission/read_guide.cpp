#include "tramline/admission/read_guide.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/admission/lonlat_reader.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

GuideLine on_the_globe(const std::vector<Point>& line, const Crs& crs, const std::string& origin) {
  GuideLine out{origin, {}, crs.plain()};
  LonlatReader read(crs, origin);
  for (const Point p : line) out.points.push_back(read(p));
  return out;
}

bool may_be_degrees(Point p) { return std::abs(p.x) <= 180 && std::abs(p.y) <= 90; }

Point placed(Point p, const GuideLine& guide, const std::optional<FrameProjection>& projection,
             const Field& field) {
  if (!projection) return p - Point{field.frame.origin_x_m, field.frame.origin_y_m};
  const std::optional<Point> local = projection->from_lonlat(p);
  if (!local)
    throw bad_input(
        fmt::format("{}: ({:.7f}, {:.7f}) lies too far from field '{}'", guide.origin, p.x, p.y, field.id));
  return *local;
}

}  // namespace

GuideLine read_guide(const RawDataset& dataset, const std::string& fields_crs) {
  const bool plain = Crs(fields_crs).plain();
  const std::string file = file_name(dataset.file);
  std::optional<GuideLine> out;
  std::string found;
  int lines = 0;
  for (const RawLayer& layer : dataset.layers) {
    const Crs crs = plain ? Crs() : Crs(layer.crs.empty() ? fields_crs : layer.crs);
    for (const RawFeature& feature : layer.features) {
      const std::string name = feature.id.empty() ? std::to_string(feature.fid) : feature.id;
      for (const std::vector<Point>& line : feature.lines) {
        ++lines;
        found += (found.empty() ? "" : ", ") + name;
        if (!out) out = on_the_globe(line, crs, fmt::format("{} feature {}", file, name));
      }
    }
  }
  if (!out) throw bad_input(fmt::format("'{}' holds no line that tracks could follow", dataset.file));
  if (lines > 1)
    throw bad_input(
        fmt::format("'{}' holds {} lines; choose the one that tracks shall follow with --guide-where: {}",
                    dataset.file, lines, found));
  return *std::move(out);
}

GuideLine guide_of_points(Point a, Point b, const std::string& origin, const std::string& crs_definition) {
  const Crs crs(crs_definition);
  const bool degrees = !crs.plain() && !crs.in_degrees() && may_be_degrees(a) && may_be_degrees(b);
  if (degrees) return on_the_globe({a, b}, Crs("EPSG:4326"), origin);
  return on_the_globe({a, b}, crs, origin);
}

std::vector<Point> placed_guide(const GuideLine& guide, const Field& field, double least_m) {
  if (guide.plain == field.frame.geodetic)
    throw bad_input(fmt::format("{}: the line and field '{}' are not in the same coordinates; give --crs",
                                guide.origin, field.id));
  std::optional<FrameProjection> projection;
  if (field.frame.geodetic) projection.emplace(field.frame);
  std::vector<Point> out;
  double length_m = 0;
  for (const Point p : guide.points) {
    const Point local = placed(p, guide, projection, field);
    if (!out.empty() && local == out.back()) continue;
    if (!out.empty()) length_m += distance(out.back(), local);
    out.push_back(local);
  }
  if (out.size() < 2 || length_m <= 0)
    throw bad_input(fmt::format("{}: the line has no length; give it two different points", guide.origin));
  if (length_m < least_m)
    throw bad_input(fmt::format(
        "{}: the line is {:.3f} m long, which is less than the working width of {} m; draw a longer one",
        guide.origin, length_m, least_m));
  double inside_m = 0;
  const Region whole{{field.outer, {}}};
  for (std::size_t i = 0; i + 1 < out.size(); ++i) inside_m += length_inside(whole, out[i], out[i + 1]);
  constexpr double kTouching = 1;  // m: lines along the boundary may lie just outside
  if (inside_m <= 0 && distance_between(whole, buffered_line(out, 0.01)) > kTouching)
    throw bad_input(
        fmt::format("{}: the line lies outside field '{}'; draw it in the field or along its edge",
                    guide.origin, field.id));
  return out;
}

}  // namespace tramline
