#include "tramline/admission/read_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/admission/lines/point_placer.h"
#include "tramline/admission/lonlat_reader.h"
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

/// The CRS of points that a user has typed: that of the fields or, where they cannot be in it, degrees if
/// possible.
Crs crs_typed(const std::vector<Point>& points, const std::string& crs_definition) {
  Crs crs(crs_definition);
  const bool degrees =
      !crs.plain() && !crs.in_degrees() && std::all_of(points.begin(), points.end(), may_be_degrees);
  return degrees ? Crs("EPSG:4326") : std::move(crs);
}

double distance_to_edge(const Field& field, Point p) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < field.outer.size(); ++i)
    out = std::min(out, distance_to_segment(p, field.outer[i], field.outer[(i + 1) % field.outer.size()]));
  return out;
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
        if (out) continue;
        out = on_the_globe(line, crs, fmt::format("{} feature {}", file, name));
        const auto role = feature.attributes.find("role");
        if (role != feature.attributes.end() && role->second == "track") out->role = GuideRole::kTrack;
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
  return on_the_globe({a, b}, crs_typed({a, b}, crs_definition), origin);
}

std::vector<Point> placed_guide(const GuideLine& guide, const Field& field, double least_m) {
  const PointPlacer placer(field, {guide.plain, guide.origin, "line"});
  std::vector<Point> out;
  double length_m = 0;
  for (const Point p : guide.points) {
    const Point local = placer.place(p);
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

GatePoints read_gates(const RawDataset& dataset, const std::string& fields_crs) {
  const bool plain = Crs(fields_crs).plain();
  GatePoints out{file_name(dataset.file), {}, plain};
  for (const RawLayer& layer : dataset.layers) {
    const Crs crs = plain ? Crs() : Crs(layer.crs.empty() ? fields_crs : layer.crs);
    LonlatReader read(crs, out.origin);
    for (const RawFeature& feature : layer.features) {
      for (const Point p : feature.points) out.points.push_back(read(p));
      for (const std::vector<Point>& line : feature.lines)
        if (!line.empty()) out.points.push_back(read(line.front()));
    }
  }
  if (out.points.empty()) throw bad_input(fmt::format("'{}' holds no point for a gate", dataset.file));
  return out;
}

GatePoints gate_of_point(Point gate, const std::string& origin, const std::string& crs_definition) {
  const GuideLine line = on_the_globe({gate}, crs_typed({gate}, crs_definition), origin);
  return {line.origin, line.points, line.plain};
}

Point placed_gate(const GatePoints& gates, const Field& field) {
  const PointPlacer placer(field, {gates.plain, gates.origin, "gate"});
  std::optional<Point> nearest;
  for (const Point p : gates.points) {
    const std::optional<Point> local = placer.try_place(p);
    if (local && (!nearest || distance_to_edge(field, *local) < distance_to_edge(field, *nearest)))
      nearest = local;
  }
  if (!nearest || distance_to_edge(field, *nearest) > kFarthestGate_m)
    throw bad_input(fmt::format("{}: there is no gate within {:.0f} m of the edge of field '{}'",
                                gates.origin, kFarthestGate_m, field.id));
  return *nearest;
}

}  // namespace tramline
