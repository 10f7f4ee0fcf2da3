#include "tramline/io/export/target_crs.h"

#include <cpl_string.h>
#include <fmt/format.h>

#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/local_crs.h"

namespace tramline::io {
namespace {

constexpr const char* kWgs84 = "EPSG:4326";

[[noreturn]] void refuse_a_place_on_earth(const Field& field, const std::string& wanted) {
  throw bad_input(
      fmt::format("field {} was planned in plain metres, so its position on earth, which {} needs, is "
                  "unknown; plan it again with --crs, or export it to .fgb or .zip",
                  field.id, wanted));
}

std::string source_definition(const Field& field) {
  if (!field.frame.geodetic) return "none";
  const std::string& definition = field.source.input_crs;
  if (definition.empty() || definition == "none")
    throw bad_input(
        "the plan does not say in which coordinate reference system its field was given (an older tramline "
        "wrote it); name one with --crs, such as --crs wgs84 or --crs EPSG:25832");
  return definition;
}

/// What Crs makes of the request, "none" for plain metres.
std::string definition_of(const Field& field, const std::string& asked, ExportFormat format) {
  if (asked.empty() && !always_wgs84(format)) return source_definition(field);
  if (EQUAL(asked.c_str(), "source")) return source_definition(field);
  if (!field.frame.geodetic && EQUAL(asked.c_str(), "none")) return "none";
  const bool wgs84 = asked.empty() || EQUAL(asked.c_str(), "wgs84");
  if (!field.frame.geodetic)
    refuse_a_place_on_earth(field, asked.empty() ? io::name(format) : "--crs " + asked);
  if (EQUAL(asked.c_str(), "none"))
    throw bad_input(
        "--crs none: the plan lies somewhere on earth; name a coordinate reference system such as "
        "EPSG:25832");
  return wgs84 ? kWgs84 : asked;
}

OGRSpatialReference reference_of(const Crs& crs, const LocalFrame& frame) {
  if (crs.plain()) return crs_of(frame);
  OGRSpatialReference out;
  // Neither files nor the network: PROJ has found the definition good, and it is nothing else.
  if (out.SetFromUserInput(crs.definition().c_str(),
                           OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE)
    throw bad_input(fmt::format(
        "GDAL does not understand the coordinate reference system {}; name another with --crs", crs.name()));
  out.DemoteTo2D(nullptr);
  out.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return out;
}

void require_wgs84(const OGRSpatialReference& reference, const Field& field, const std::string& asked,
                   ExportFormat format) {
  if (!always_wgs84(format)) return;
  if (!field.frame.geodetic) refuse_a_place_on_earth(field, io::name(format));
  OGRSpatialReference wgs84;
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
  if (wgs84.SetWellKnownGeogCS("WGS84") == OGRERR_NONE && reference.IsSame(&wgs84, options) != 0) return;
  throw bad_input(fmt::format("--crs {}: {} is always in WGS 84; leave --crs out, or export to .fgb or .zip",
                              asked, io::name(format)));
}

}  // namespace

TargetCrs::TargetCrs(const Field& field, const std::string& asked, ExportFormat format)
    : crs_(definition_of(field, asked, format)),
      projection_(crs_, field.frame),
      reference_(reference_of(crs_, field.frame)) {
  require_wgs84(reference_, field, asked, format);
}

std::optional<Point> TargetCrs::to_local(Point target) const { return projection_.to_local(target); }

Point TargetCrs::from_local(Point local_m) const {
  if (plain()) return projection_.to_input(local_m);
  const Point lonlat = projection_.to_lonlat(local_m);
  const std::optional<Point> target = crs_.is_near(lonlat) ? crs_.from_lonlat(lonlat) : std::nullopt;
  const std::optional<Point> back = target ? to_local(*target) : std::nullopt;
  constexpr double kMost_m = 1e-4;
  if (back && distance(*back, local_m) <= kMost_m) return *target;
  throw bad_input(fmt::format(
      "the field lies outside the area of {}; name another coordinate reference system with --crs",
      crs_.name()));
}

}  // namespace tramline::io
