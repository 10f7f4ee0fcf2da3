#include "tramline/admission/admit.h"

#include <fmt/format.h>

#include "tramline/admission/project_rings.h"
#include "tramline/admission/repair_log.h"
#include "tramline/admission/repair_part.h"
#include "tramline/admission/zone_prefix.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

// Wider than any field, and within it the scale of the local frame is true to 3 in 10,000.
constexpr double kWidestField_m = 300e3;

/// What is known of the feature as a whole while its parts are worked through.
struct Case {
  const RawFeature& feature;
  const AdmissionContext& context;
  std::string id;
  std::string subject;
  double prefix_m = 0;
};

void refuse_other_geometry(const Case& c) {
  if (!c.feature.polygons.empty()) return;
  if (c.feature.geometry_type == "none")
    throw bad_input(fmt::format("{}: the feature has no geometry; give it a polygon", c.subject));
  throw bad_input(fmt::format(
      "{}: the geometry is a {}, not a polygon with land in it; draw the field's boundary as a polygon",
      c.subject, c.feature.geometry_type));
}

FieldProjection projection_for(const RawPolygon& part, const Case& c) {
  const Box box = bounds(part.rings[0].points);
  const Crs& crs = *c.context.crs;
  check_not_degrees(box, crs, c.subject);
  if (crs.in_degrees() && box.width() > 180)
    throw bad_input(fmt::format(
        "{}: the field crosses the 180th meridian; cut it there or give it in a projected CRS", c.subject));
  try {
    return FieldProjection(crs, frame_centred_on(crs, box));
  } catch (const Error& error) {
    throw Error(error.kind(), c.subject + ": " + error.what());
  }
}

void refuse_wide(const Lobe& lobe, const Case& c) {
  const Box box = bounds(lobe.outer);
  if (!c.context.crs->plain() && std::max(box.width(), box.height()) > kWidestField_m)
    throw bad_input(fmt::format(
        "{}: the field is {:.0f} km wide; check its coordinates and give the right CRS with --crs", c.subject,
        std::max(box.width(), box.height()) / 1000));
}

/// The last word, by another road than the repairs: GEOS's own validity test.
void verify(const Lobe& lobe, const RepairLog& repair_log) {
  if (const auto fault = find_invalidity({lobe.outer, {}}))
    throw repair_log.refusal(fmt::format("the outer ring could not be repaired at {} ({}); redraw it there",
                                         repair_log.shown(fault->place), fault->reason));
  for (const Obstacle& obstacle : lobe.obstacles)
    if (const auto fault = find_invalidity(obstacle.shape))
      throw repair_log.refusal(fmt::format("{} could not be repaired at {} ({}); redraw it there",
                                           obstacle.origin, repair_log.shown(fault->place), fault->reason));
}

Field make_field(Lobe lobe, const Case& c, const LocalFrame& frame) {
  Field field;
  field.outer = std::move(lobe.outer);
  field.obstacles = std::move(lobe.obstacles);
  field.frame = frame;
  field.source = {c.context.file, c.context.layer, c.feature.fid, 0};
  return field;
}

/// Adds the fields of one part; a part without area is remembered in `empty`.
void admit_part(const RawPolygon& part, const Case& c, std::vector<Field>& fields,
                std::vector<std::string>& empty) {
  if (part.rings.empty() || part.rings[0].points.empty()) {
    empty.emplace_back("its outer ring is empty");
    return;
  }
  check_coordinates(part, *c.context.crs, c.subject);
  const FieldProjection projection = projection_for(part, c);
  RepairLog repair_log(c.subject, projection, c.prefix_m);
  std::string why_empty;
  std::vector<Lobe> lobes = repair_part(part, c.context.winding, repair_log, why_empty);
  if (lobes.empty()) {
    empty.push_back(why_empty);
    return;
  }
  for (std::size_t k = 0; k < lobes.size(); ++k) {
    refuse_wide(lobes[k], c);
    verify(lobes[k], repair_log);
    Field field = make_field(std::move(lobes[k]), c, projection.frame());
    if (k == 0) {
      field.repairs = repair_log.repairs();
      field.warnings = repair_log.warnings();
    } else {
      field.warnings.emplace_back(
          "a lobe that the outer ring cut off by crossing itself; its repairs are listed with the first");
    }
    fields.push_back(std::move(field));
  }
}

/// Repairs that concern the feature rather than one ring; they are listed with its first field.
void note_feature_repairs(const Case& c, const std::vector<std::string>& empty, Field& first) {
  Point at;
  for (const RawPolygon& part : c.feature.polygons)
    if (!part.rings.empty() && !part.rings[0].points.empty()) {
      at = part.rings[0].points[0];
      break;
    }
  at.x += c.prefix_m;
  std::vector<Repair> notes;
  if (c.prefix_m != 0)
    notes.push_back(
        {fmt::format("the eastings carried the zone number {:.0f}; it was taken off", c.prefix_m / 1e6),
         "whole feature", at, 0});
  if (c.feature.had_z) notes.push_back({"heights (Z) were left out", "whole feature", at, 0});
  if (c.feature.had_m) notes.push_back({"measures (M) were left out", "whole feature", at, 0});
  if (c.feature.was_curved)
    notes.push_back({"arcs were replaced by chords of at most 1 degree", "whole feature", at, 0});
  for (const std::string& why : empty)
    notes.push_back({fmt::format("a polygon of the feature was left out: {}", why), "whole feature", at, 0});
  first.repairs.insert(first.repairs.begin(), notes.begin(), notes.end());
}

std::vector<Skipped> beside_the_polygons(const Case& c) {
  std::vector<Skipped> out;
  if (!c.feature.lines.empty())
    out.push_back(
        {fmt::format("{} line(s)", c.feature.lines.size()), c.subject, "a field is made of polygons"});
  if (!c.feature.points.empty())
    out.push_back(
        {fmt::format("{} point(s)", c.feature.points.size()), c.subject, "a field is made of polygons"});
  return out;
}

}  // namespace

std::string field_id(const RawFeature& feature, const std::string& layer) {
  return feature.id.empty() ? fmt::format("{}:{}", layer, feature.fid) : feature.id;
}

Admission admit(const RawFeature& feature, const AdmissionContext& context) {
  const std::string id = field_id(feature, context.layer);
  const std::string subject = fmt::format("{}, feature '{}'", context.file, id);
  const std::optional<double> prefix = zone_prefix_m(feature, *context.crs, subject);
  const RawFeature plain = prefix ? without_prefix(feature, *prefix) : feature;
  const Case c{plain, context, id, subject, prefix.value_or(0)};
  refuse_other_geometry(c);

  Admission out;
  std::vector<std::string> empty;
  for (const RawPolygon& part : plain.polygons) admit_part(part, c, out.fields, empty);
  if (out.fields.empty())
    throw bad_input(fmt::format("{}: the polygon has no area because {}; redraw it", subject, empty.front()));
  note_feature_repairs(c, empty, out.fields.front());
  for (std::size_t k = 0; k < out.fields.size(); ++k) {
    out.fields[k].id = k == 0 ? id : fmt::format("{}#{}", id, k + 1);
    out.fields[k].source.part = static_cast<int>(k);
  }
  out.skipped = beside_the_polygons(c);
  return out;
}

}  // namespace tramline
