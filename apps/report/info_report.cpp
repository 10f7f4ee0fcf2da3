#include "report/info_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "report/report_parts.h"
#include "request/field_key.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

std::size_t vertices(const Field& field) {
  std::size_t sum = field.outer.size();
  for (const Obstacle& obstacle : field.obstacles) sum += vertex_count({obstacle.shape});
  return sum;
}

const char* kind_name(ObstacleKind kind) { return kind == ObstacleKind::kPassable ? "passable" : "obstacle"; }

/// Degrees with 7 decimals (1 cm), metres with 2.
std::string place(Point at, const LocalFrame& frame) {
  const bool degrees = frame.geodetic && std::abs(at.x) <= 180 && std::abs(at.y) <= 90;
  return degrees ? fmt::format("({:.7f}, {:.7f})", at.x, at.y) : fmt::format("({:.2f}, {:.2f})", at.x, at.y);
}

std::string frame_row(const LocalFrame& frame) {
  if (!frame.geodetic)
    return fmt::format("frame        plain metres, origin at x {:.0f} m, y {:.0f} m of the input\n",
                       frame.origin_x_m, frame.origin_y_m);
  return fmt::format(
      "frame        transverse Mercator, WGS 84, scale 1, origin at longitude {:.7f}°, latitude {:.7f}°\n",
      frame.origin_lon_deg, frame.origin_lat_deg);
}

/// The sentence without the ring's name, which `where` begins with.
std::string without_ring(const Repair& repair) {
  const std::string ring = repair.where.substr(0, repair.where.find(',')) + " ";
  return repair.what.rfind(ring, 0) == 0 ? repair.what.substr(ring.size()) : repair.what;
}

std::string count(std::size_t number, const char* one, const char* several) {
  return fmt::format("{} {}", number, number == 1 ? one : several);
}

ordered_json frame_json(const LocalFrame& frame) {
  if (!frame.geodetic)
    return {{"kind", "plain metres"}, {"origin_x_m", frame.origin_x_m}, {"origin_y_m", frame.origin_y_m}};
  return {{"kind", "transverse Mercator"},
          {"origin_lon_deg", frame.origin_lon_deg},
          {"origin_lat_deg", frame.origin_lat_deg}};
}

ordered_json obstacles_json(const Field& field) {
  ordered_json out = ordered_json::array();
  for (const Obstacle& obstacle : field.obstacles)
    out.push_back({{"origin", obstacle.origin},
                   {"kind", kind_name(obstacle.kind)},
                   {"area_m2", area(obstacle.shape)},
                   {"vertices", vertex_count({obstacle.shape})}});
  return out;
}

ordered_json source_json(const std::string& file, const FieldInput& input) {
  return {{"file", file},
          {"driver", input.driver},
          {"layer", input.layer},
          {"crs", input.crs},
          {"crs_from", input.crs_given ? "--crs" : "file"}};
}

}  // namespace

std::string source_rows(const std::string& file, const FieldInput& input) {
  return fmt::format("file         {} ({})\n", file, input.driver) +
         fmt::format("layer        {} ({}), {}\n", input.layer, input.layer_geometry,
                     count(static_cast<std::size_t>(input.features), "feature", "features")) +
         fmt::format("CRS          {}{}\n", input.crs, input.crs_given ? ", given by --crs" : "");
}

std::string field_rows(const Field& field) {
  std::string out;
  const auto add = std::back_inserter(out);
  fmt::format_to(add, "field        {} (key {}: feature {}, part {})\n", field.id, field_key(field),
                 field.source.fid, field.source.part + 1);
  out += frame_row(field.frame);
  fmt::format_to(add, "area         {:.1f} m² ({:.4f} ha), {:.1f} m² without its obstacles\n",
                 signed_area(field.outer), signed_area(field.outer) / 1e4, area_m2(field));
  fmt::format_to(add, "boundary     {:.1f} m, {} vertices\n", perimeter(field.outer), field.outer.size());
  fmt::format_to(add, "obstacles    {}\n", field.obstacles.size());
  for (const Obstacle& obstacle : field.obstacles)
    fmt::format_to(add, "  {:<11}{}: {:.2f} m², {} vertices\n", kind_name(obstacle.kind), obstacle.origin,
                   area(obstacle.shape), vertex_count({obstacle.shape}));
  fmt::format_to(add, "repairs      {}\n", field.repairs.size());
  for (const Repair& repair : field.repairs)
    fmt::format_to(add, "  {}: {}, at {}, area {:+.3f} m²\n", repair.where, without_ring(repair),
                   place(repair.at, field.frame), repair.area_change_m2 + 0.0);
  fmt::format_to(add, "{}", note_rows(field.warnings));
  return out;
}

std::string candidate_rows(const FieldInput& input) {
  std::size_t width = 5, key_width = 3;
  for (const Field& field : input.fields) {
    width = std::max(width, field.id.size());
    key_width = std::max(key_width, field_key(field).size());
  }
  for (const Refusal& refusal : input.refusals) width = std::max(width, refusal.field_id.size());
  std::string out;
  const auto add = std::back_inserter(out);
  fmt::format_to(add, "{:<{}}  {:<{}}  {:>14}  {:>8}  {:>9}  {:>7}\n", "field", width, "key", key_width,
                 "area, m²", "vertices", "obstacles", "repairs");
  for (const Field& field : input.fields)
    fmt::format_to(add, "{:<{}}  {:<{}}  {:>14.1f}  {:>8}  {:>9}  {:>7}\n", field.id, width, field_key(field),
                   key_width, area_m2(field), vertices(field), field.obstacles.size(), field.repairs.size());
  for (const Refusal& refusal : input.refusals)
    fmt::format_to(add, "{:<{}}  refused: {}\n", refusal.field_id, width, refusal.sentence);
  return out;
}

ordered_json field_json(const std::string& file, const FieldInput& input, const Field& field) {
  ordered_json out{{"field_id", field.id}, {"key", field_key(field)}};
  out.update(source_json(file, input));
  out["feature"] = field.source.fid;
  out["part"] = field.source.part;
  out["frame"] = frame_json(field.frame);
  out["outline_m2"] = signed_area(field.outer);
  out["area_m2"] = area_m2(field);
  out["perimeter_m"] = perimeter(field.outer);
  out["vertices"] = vertices(field);
  out["obstacles"] = obstacles_json(field);
  out["repairs"] = repairs_json(field.repairs);
  out["warnings"] = field.warnings;
  return out;
}

ordered_json candidates_json(const std::string& file, const FieldInput& input) {
  ordered_json out = source_json(file, input);
  out["features"] = input.features;
  out["candidates"] = ordered_json::array();
  for (const Field& field : input.fields)
    out["candidates"].push_back({{"field_id", field.id},
                                 {"key", field_key(field)},
                                 {"area_m2", area_m2(field)},
                                 {"vertices", vertices(field)},
                                 {"obstacles", field.obstacles.size()},
                                 {"repairs", field.repairs.size()}});
  for (const Refusal& refusal : input.refusals)
    out["candidates"].push_back(refusal_json(input.file, input.layer, refusal));
  out["skipped"] = skipped_json(input.skipped);
  return out;
}

}  // namespace tramline::app
