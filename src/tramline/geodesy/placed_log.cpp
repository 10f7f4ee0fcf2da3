#include "tramline/geodesy/placed_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "tramline/geodesy/crs.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"
#include "tramline/model/limits.h"

namespace tramline {
namespace {

/// Further from the frame's origin no machine works that field: what is left is a fault of the log.
constexpr double kFarFromFrame_m = 1e6;

/// The reason why a position is not one; empty where it is.
std::string fault(Positions positions, Point p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return "the position is no number";
  if (positions == Positions::kLocal)
    return length(p) > kFarthest_m ? fmt::format("the position ({:.10g}, {:.10g}) is too far away", p.x, p.y)
                                   : "";
  if (p.x == 0 && p.y == 0) return "longitude and latitude are 0";
  if (std::abs(p.y) > 90) return fmt::format("the latitude {:.10g} is past a pole", p.y);
  if (std::abs(p.x) > 180) return fmt::format("there is no longitude {:.10g}", p.x);
  return "";
}

double distance_between(const Box& box, Point p) {
  const double x = std::max({box.min_x - p.x, 0.0, p.x - box.max_x});
  const double y = std::max({box.min_y - p.y, 0.0, p.y - box.max_y});
  return length(Point{x, y});
}

}  // namespace

Box bounds(const WorkLog& log) {
  Box box;
  for (const Fix& fix : log.fixes)
    if (fault(log.positions, fix.position).empty()) box.extend(fix.position);
  return box;
}

LocalFrame frame_centred_on(const WorkLog& log) {
  const Box box = bounds(log);
  if (box.empty()) throw bad_input(log.name + " has no fix with a position: is it a log?");
  return frame_centred_on(log.positions == Positions::kLonLat ? Crs("EPSG:4326") : Crs(), box);
}

FixPlacing::FixPlacing(Positions positions, const LocalFrame& frame, const std::string& name)
    : positions_(positions), frame_(frame) {
  if (frame.geodetic != (positions == Positions::kLonLat))
    throw bad_input(fmt::format(
        "{} has positions in {} and the field is in {}; give the CRS of the one without with --crs or "
        "--log-crs",
        name, frame.geodetic ? "plain metres" : "degrees", frame.geodetic ? "degrees" : "plain metres"));
  if (positions == Positions::kLonLat) projection_.emplace(frame);
}

std::optional<Point> FixPlacing::operator()(Point position, std::string& why) const {
  why = fault(positions_, position);
  if (!why.empty()) return std::nullopt;
  const std::optional<Point> local =
      projection_ ? projection_->from_lonlat(position)
                  : std::optional(Point{position.x - frame_.origin_x_m, position.y - frame_.origin_y_m});
  if (local && length(*local) <= kFarFromFrame_m) return local;
  why = "the position is more than 1000 km away";
  return std::nullopt;
}

bool comes_near(const WorkLog& log, const LocalFrame& frame, const Box& local, double within_m) {
  const FixPlacing place(log.positions, frame, log.name);
  return std::any_of(log.fixes.begin(), log.fixes.end(), [&](const Fix& fix) {
    std::string why;
    const std::optional<Point> p = place(fix.position, why);
    return p && distance_between(local, *p) < within_m;
  });
}

namespace {

bool place_shape(Polygon& shape, const FixPlacing& place, std::string& why) {
  const auto place_ring = [&](Ring& ring) {
    for (Point& corner : ring) {
      const std::optional<Point> local = place(corner, why);
      if (!local) return false;
      corner = *local;
    }
    return true;
  };
  if (!place_ring(shape.outer) || !std::all_of(shape.holes.begin(), shape.holes.end(), place_ring))
    return false;
  shape = oriented(std::move(shape));
  return true;
}

}  // namespace

WorkLog placed(WorkLog log, const LocalFrame& frame) {
  const FixPlacing place(log.positions, frame, log.name);
  skip_faulty(log, [&](Fix& fix) {
    std::string why;
    const std::optional<Point> local = place(fix.position, why);
    if (!local) return why;
    fix.position = *local;
    if (fix.shape >= 0 && !place_shape(log.shapes[static_cast<std::size_t>(fix.shape)], place, why))
      return why;
    return std::string();
  });
  log.positions = Positions::kLocal;
  return log;
}

}  // namespace tramline
