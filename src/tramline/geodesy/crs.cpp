#include "tramline/geodesy/crs.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "tramline/geodesy/proj_handle.h"
#include "tramline/geometry/error.h"

namespace tramline {

struct Crs::Impl {
  proj::Context context;
  proj::Object to_wgs84;
  proj::Object crs;
  bool no_op = false;  ///< the input is WGS 84 longitude and latitude already: keep every digit
};

namespace {

std::string name_of(PJ_CONTEXT*, const PJ* crs) {
  const char* name = proj_get_name(crs);
  std::string out = name != nullptr && *name != '\0' ? name : "unnamed CRS";
  const char* authority = proj_get_id_auth_name(crs, 0);
  const char* code = proj_get_id_code(crs, 0);
  if (authority != nullptr && code != nullptr) out += fmt::format(" ({}:{})", authority, code);
  return out;
}

/// A code as one word, else the whole CRS.
std::string definition_of(PJ_CONTEXT* context, const PJ* crs) {
  const char* authority = proj_get_id_auth_name(crs, 0);
  const char* code = proj_get_id_code(crs, 0);
  if (authority != nullptr && code != nullptr) {
    std::string short_form = fmt::format("{}:{}", authority, code);
    const proj::Object named(proj_create(context, short_form.c_str()));
    // A file may carry a code and mean something else by it.
    if (named != nullptr &&
        proj_is_equivalent_to(crs, named.get(), PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0)
      return short_form;
  }
  const char* const options[] = {"MULTILINE=NO", nullptr};
  const char* text = proj_as_wkt(context, crs, PJ_WKT2_2019, options);
  return text != nullptr ? text : "";
}

bool usable(PJ_TYPE type) {
  switch (type) {
    case PJ_TYPE_GEOGRAPHIC_2D_CRS:
    case PJ_TYPE_GEOGRAPHIC_3D_CRS:
    case PJ_TYPE_PROJECTED_CRS:
    case PJ_TYPE_COMPOUND_CRS:
    case PJ_TYPE_BOUND_CRS:
      return true;
    default:
      return false;
  }
}

/// The horizontal CRS inside compound and bound ones.
proj::Object horizontal(PJ_CONTEXT* context, proj::Object crs) {
  for (int depth = 0; depth < 4; ++depth) {
    const PJ_TYPE type = proj_get_type(crs.get());
    PJ* inner = nullptr;
    if (type == PJ_TYPE_COMPOUND_CRS) inner = proj_crs_get_sub_crs(context, crs.get(), 0);
    if (type == PJ_TYPE_BOUND_CRS) inner = proj_get_source_crs(context, crs.get());
    if (inner == nullptr) return crs;
    crs.reset(inner);
  }
  return crs;
}

bool has_degree_axes(PJ_CONTEXT* context, const PJ* crs) {
  const PJ_TYPE type = proj_get_type(crs);
  if (type != PJ_TYPE_GEOGRAPHIC_2D_CRS && type != PJ_TYPE_GEOGRAPHIC_3D_CRS) return false;
  const proj::Object axes(proj_crs_get_coordinate_system(context, crs));
  double factor = 0;
  if (axes == nullptr || !proj_cs_get_axis_info(context, axes.get(), 0, nullptr, nullptr, nullptr, &factor,
                                                nullptr, nullptr, nullptr))
    return false;
  return std::abs(factor - M_PI / 180) < 1e-12;
}

/// PROJ takes any word for the beginning of a name ("foo" for Amersfoort); only whole names and codes count
/// here.
bool is_definition(const std::string& text, const PJ* crs) {
  if (text.find_first_of(":[{+=") != std::string::npos) return true;
  const char* name = proj_get_name(crs);
  return name != nullptr && text == name;
}

std::optional<double> parameter(PJ_CONTEXT* context, const PJ* operation, const char* epsg_name,
                                double& to_si) {
  const int index = proj_coordoperation_get_param_index(context, operation, epsg_name);
  double value = 0;
  if (index < 0 ||
      !proj_coordoperation_get_param(context, operation, index, nullptr, nullptr, nullptr, &value, nullptr,
                                     &to_si, nullptr, nullptr, nullptr, nullptr))
    return std::nullopt;
  return value;
}

std::optional<TransverseMercatorGrid> grid_of(PJ_CONTEXT* context, const PJ* crs) {
  if (proj_get_type(crs) != PJ_TYPE_PROJECTED_CRS) return std::nullopt;
  const proj::Object operation(proj_crs_get_coordoperation(context, crs));
  const char* method = nullptr;
  if (operation == nullptr ||
      !proj_coordoperation_get_method_info(context, operation.get(), &method, nullptr, nullptr) ||
      method == nullptr || std::string(method) != "Transverse Mercator")
    return std::nullopt;
  double metre = 1, degree = 1;
  const auto easting = parameter(context, operation.get(), "False easting", metre);
  const auto meridian = parameter(context, operation.get(), "Longitude of natural origin", degree);
  if (!easting || !meridian || metre != 1) return std::nullopt;
  return TransverseMercatorGrid{*easting, *meridian * degree * 180 / M_PI};
}

std::optional<Point> transformed(PJ* operation, PJ_DIRECTION way, Point p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return std::nullopt;
  proj_errno_reset(operation);
  const PJ_COORD out = proj_trans(operation, way, proj_coord(p.x, p.y, 0, HUGE_VAL));
  if (proj_errno(operation) != 0 || !std::isfinite(out.xy.x) || !std::isfinite(out.xy.y)) return std::nullopt;
  return Point{out.xy.x, out.xy.y};
}

}  // namespace

Crs::Crs() = default;
Crs::Crs(Crs&&) noexcept = default;
Crs& Crs::operator=(Crs&&) noexcept = default;
Crs::~Crs() = default;

Crs::Crs(const std::string& definition) {
  if (definition.empty() || definition == "none") return;
  auto impl = std::make_unique<Impl>();
  impl->context = proj::make_context();
  PJ_CONTEXT* context = impl->context.get();
  proj::Object crs(proj_create(context, definition.c_str()));
  const std::string shown = definition.substr(0, definition.find('\n')).substr(0, 60);
  if (crs == nullptr || !is_definition(definition, crs.get()))
    throw bad_input(fmt::format(
        "'{}' is not a coordinate reference system that PROJ knows; give one such as --crs EPSG:25832",
        shown));
  if (!usable(proj_get_type(crs.get())))
    throw bad_input(
        fmt::format("'{}' is neither a geographic nor a projected coordinate reference system; give one such "
                    "as --crs EPSG:25832",
                    shown));
  name_ = name_of(context, crs.get());
  crs = horizontal(context, std::move(crs));
  definition_ = definition_of(context, crs.get());
  in_degrees_ = has_degree_axes(context, crs.get());
  grid_ = grid_of(context, crs.get());

  const proj::Object wgs84(proj_create(context, "OGC:CRS84"));
  if (wgs84 == nullptr)
    throw failure("PROJ does not find its database proj.db; install the package proj-data");
  impl->no_op =
      proj_is_equivalent_to(crs.get(), wgs84.get(), PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
  const proj::Object operation(
      proj_create_crs_to_crs_from_pj(context, crs.get(), wgs84.get(), nullptr, nullptr));
  if (operation != nullptr) impl->to_wgs84.reset(proj_normalize_for_visualization(context, operation.get()));
  if (impl->to_wgs84 == nullptr)
    throw bad_input(fmt::format("PROJ cannot transform '{}' to WGS 84 ({}); give another CRS with --crs",
                                name_, proj::last_error(context)));
  impl->crs = std::move(crs);
  impl_ = std::move(impl);
}

bool Crs::is_near(Point lonlat_deg) const {
  double west = 0, south = 0, east = 0, north = 0;
  constexpr double kUnknown = -1000, kMargin_deg = 12;
  if (plain() ||
      proj_get_area_of_use(impl_->context.get(), impl_->crs.get(), &west, &south, &east, &north, nullptr) ==
          0 ||
      west == kUnknown)
    return true;
  // Around the earth from west to east, which may lie on both sides of 180 degrees.
  const double width = east < west ? east - west + 360 : east - west;
  const double from_middle = std::remainder(lonlat_deg.x - (west + 0.5 * width), 360);
  return std::abs(from_middle) <= 0.5 * width + kMargin_deg && lonlat_deg.y >= south - kMargin_deg &&
         lonlat_deg.y <= north + kMargin_deg;
}

std::optional<Point> Crs::to_lonlat(Point input) const {
  assert(!plain());
  if (impl_->no_op)
    return std::isfinite(input.x) && std::isfinite(input.y) ? std::optional(input) : std::nullopt;
  return transformed(impl_->to_wgs84.get(), PJ_FWD, input);
}

std::optional<Point> Crs::from_lonlat(Point lonlat_deg) const {
  assert(!plain());
  if (impl_->no_op) return lonlat_deg;
  PJ* operation = impl_->to_wgs84.get();
  const std::optional<Point> near = transformed(operation, PJ_INV, lonlat_deg);
  if (!near) return std::nullopt;
  // A datum shift moves heights too, which plane coordinates cannot carry; the way back is then off by up to
  // a millimetre. Aiming again by the miss takes that away.
  const std::optional<Point> hit = transformed(operation, PJ_FWD, *near);
  return hit ? transformed(operation, PJ_INV, 2 * lonlat_deg - *hit) : near;
}

}  // namespace tramline
