#include "request/evaluate_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tramline/coverage/drive/plan_steps.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geodesy/placed_log.h"
#include "tramline/geometry/error.h"
#include "tramline/headland/body.h"

namespace tramline::app {
namespace {

/// From one frame of the field's parts to another's.
class BetweenFrames {
 public:
  BetweenFrames(const LocalFrame& from, const LocalFrame& to)
      : shift_{from.origin_x_m - to.origin_x_m, from.origin_y_m - to.origin_y_m} {
    if (!from.geodetic) return;
    from_.emplace(from);
    to_.emplace(to);
  }

  Point operator()(Point p) const {
    if (!from_) return p + shift_;
    const std::optional<Point> local = to_->from_lonlat(from_->to_lonlat(p));
    if (!local) throw bad_input("the parts of the field lie too far apart for one plane");
    return *local;
  }

 private:
  Point shift_;
  std::optional<FrameProjection> from_, to_;
};

WorkLog with_columns_swapped(WorkLog log) {
  for (Fix& fix : log.fixes) std::swap(fix.position.x, fix.position.y);
  return log;
}

void require_near(const WorkLog& log, const WorkGround& ground) {
  const Box field = bounds(ground.ground);
  if (comes_near(log, ground.frame, field, kNear_m)) return;
  if (comes_near(with_columns_swapped(log), ground.frame, field, kNear_m))
    throw bad_input(fmt::format(
        "{} lies nowhere near the field {} as it is, but does with longitude and latitude swapped: give "
        "--columns lon=LATITUDE,lat=LONGITUDE with the names of its columns",
        log.name, ground.field_id));
  const Box box = bounds(log);
  throw bad_input(fmt::format(
      "{} lies nowhere near the field {}: the log is about ({:.5f}, {:.5f}){}; give the "
      "field it was driven on, or none",
      log.name, ground.field_id, box.centre().x, box.centre().y,
      ground.frame.geodetic ? fmt::format(" and the field about ({:.5f}, {:.5f})",
                                          ground.frame.origin_lon_deg, ground.frame.origin_lat_deg)
                            : ""));
}

}  // namespace

Region moved(Region region, const LocalFrame& from, const LocalFrame& to) {
  if (from == to) return region;
  const BetweenFrames between(from, to);
  const auto move = [&](Ring& ring) {
    for (Point& p : ring) p = between(p);
  };
  for (Polygon& polygon : region) {
    move(polygon.outer);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), move);
  }
  return region;
}

std::optional<WorkGround> work_ground(const FieldOptions& options) {
  if (options.file.empty()) return std::nullopt;
  const FieldInput input = load_fields(options);
  WorkGround out;
  // Parts of a feature have a frame each.
  for (const Field& field : input.fields) {
    if (out.field_id.empty()) {
      out.field_id = field.id;
      out.frame = field.frame;
    }
    for (Polygon& polygon : moved(body_of(field), field.frame, out.frame))
      out.ground.push_back(oriented(std::move(polygon)));
  }
  return out;
}

WorkGround work_ground(const Plan& plan) { return {plan.field.id, body_of(plan.field), plan.field.frame}; }

coverage::FurtherWork work_of(const Plan& plan, const LocalFrame& frame) {
  coverage::FurtherWork out{coverage::steps_of(plan), {}};
  for (const TrackPiece& piece : plan.pieces) out.lines.push_back(chords(centre_line(piece)));
  for (const HeadlandPass& pass : plan.headland.passes) out.lines.push_back(chords(pass.path));
  if (plan.field.frame == frame) return out;
  const BetweenFrames between(plan.field.frame, frame);
  for (coverage::WorkedStep& step : out.steps)
    for (coverage::Quad& quad : step.quads)
      for (Point& p : quad) p = between(p);
  for (std::vector<Point>& line : out.lines)
    for (Point& p : line) p = between(p);
  return out;
}

WorkLog placed_on(WorkLog log, WorkGround& ground) {
  if (ground.ground.empty())
    ground.frame = frame_centred_on(log);
  else
    require_near(log, ground);
  return placed(std::move(log), ground.frame);
}

}  // namespace tramline::app
