#include "tramline/geodesy/field_projection.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <string>

#include "tramline/geodesy/proj_handle.h"
#include "tramline/geometry/error.h"

namespace tramline {

struct FrameProjection::Impl {
  proj::Context context;
  proj::Object lonlat_to_local;
};

FrameProjection::FrameProjection(const LocalFrame& frame) : impl_(std::make_unique<Impl>()) {
  assert(frame.geodetic);
  impl_->context = proj::make_context();
  const std::string pipeline = fmt::format(
      "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad "
      "+step +proj=tmerc +lat_0={:.17g} +lon_0={:.17g} +k=1 +ellps=WGS84",
      frame.origin_lat_deg, frame.origin_lon_deg);
  impl_->lonlat_to_local.reset(proj_create(impl_->context.get(), pipeline.c_str()));
  if (impl_->lonlat_to_local == nullptr)
    throw failure("PROJ could not make the field's frame: " + proj::last_error(impl_->context.get()));
}
FrameProjection::FrameProjection(FrameProjection&&) noexcept = default;
FrameProjection& FrameProjection::operator=(FrameProjection&&) noexcept = default;
FrameProjection::~FrameProjection() = default;

std::optional<Point> FrameProjection::from_lonlat(Point lonlat_deg) const {
  PJ* operation = impl_->lonlat_to_local.get();
  proj_errno_reset(operation);
  const PJ_COORD out = proj_trans(operation, PJ_FWD, proj_coord(lonlat_deg.x, lonlat_deg.y, 0, HUGE_VAL));
  if (proj_errno(operation) != 0 || !std::isfinite(out.xy.x) || !std::isfinite(out.xy.y)) return std::nullopt;
  return Point{out.xy.x, out.xy.y};
}

Point FrameProjection::to_lonlat(Point local_m) const {
  PJ* operation = impl_->lonlat_to_local.get();
  proj_errno_reset(operation);
  const PJ_COORD out = proj_trans(operation, PJ_INV, proj_coord(local_m.x, local_m.y, 0, HUGE_VAL));
  if (proj_errno(operation) != 0 || !std::isfinite(out.xy.x) || !std::isfinite(out.xy.y))
    throw failure(fmt::format("the local point ({:.3f} m, {:.3f} m) lies outside the field's projection",
                              local_m.x, local_m.y));
  return {out.xy.x, out.xy.y};
}

LocalFrame frame_centred_on(const Crs& crs, const Box& bounds) {
  LocalFrame frame;
  const Point centre = bounds.centre();
  if (crs.plain()) {
    frame.origin_x_m = std::round(centre.x);
    frame.origin_y_m = std::round(centre.y);
    return frame;
  }
  const std::optional<Point> lonlat = crs.to_lonlat(centre);
  if (!lonlat)
    throw bad_input(
        fmt::format("the field's centre ({:.10g}, {:.10g}) lies outside {}; give the right CRS with --crs",
                    centre.x, centre.y, crs.name()));
  frame.geodetic = true;
  frame.origin_lon_deg = std::round(lonlat->x * 1e7) / 1e7;
  frame.origin_lat_deg = std::round(lonlat->y * 1e7) / 1e7;
  return frame;
}

FieldProjection::FieldProjection(const Crs& crs, const LocalFrame& frame) : crs_(&crs), frame_(frame) {
  assert(frame.geodetic == !crs.plain());
  if (frame.geodetic) projection_.emplace(frame);
}

std::optional<Point> FieldProjection::to_local(Point input) const {
  if (!projection_) {
    if (!std::isfinite(input.x) || !std::isfinite(input.y)) return std::nullopt;
    return Point{input.x - frame_.origin_x_m, input.y - frame_.origin_y_m};
  }
  const std::optional<Point> lonlat = crs_->to_lonlat(input);
  return lonlat ? projection_->from_lonlat(*lonlat) : std::nullopt;
}

Point FieldProjection::to_input(Point local_m) const {
  if (!projection_) return {local_m.x + frame_.origin_x_m, local_m.y + frame_.origin_y_m};
  const std::optional<Point> input = crs_->from_lonlat(projection_->to_lonlat(local_m));
  if (!input)
    throw failure(fmt::format("the local point ({:.3f} m, {:.3f} m) cannot be expressed in {}", local_m.x,
                              local_m.y, crs_->name()));
  return *input;
}

Point FieldProjection::to_lonlat(Point local_m) const {
  if (!projection_)
    throw failure(
        "the field is in plain metres, so it has no longitude and latitude; give its CRS with --crs");
  return projection_->to_lonlat(local_m);
}

}  // namespace tramline
