#include "tramline/io/plan/common_frame.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <optional>

#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

/// Text holds 1e-7 degrees exactly.
double rounded(double degrees) { return std::round(degrees * 1e7) / 1e7; }

/// A transverse Mercator that leads back to the same place within this is one to keep plans in.
constexpr double kWayBack_m = 1e-6;

/// From -180 to 180, whatever side of the date line.
double difference_deg(double lon, double from) { return std::remainder(lon - from, 360.0); }

}  // namespace

LocalFrame common_frame(const std::vector<LocalFrame>& frames) {
  assert(!frames.empty());
  const LocalFrame& first = frames.front();
  if (std::any_of(frames.begin(), frames.end(),
                  [&](const LocalFrame& frame) { return frame.geodetic != first.geodetic; }))
    throw bad_input(
        "some plans are in plain metres and others have geographic positions; one file can hold plans of one "
        "kind only");
  LocalFrame out;
  if (!first.geodetic) return out;
  double west = 0, east = 0, south = first.origin_lat_deg, north = south;
  for (const LocalFrame& frame : frames) {
    west = std::min(west, difference_deg(frame.origin_lon_deg, first.origin_lon_deg));
    east = std::max(east, difference_deg(frame.origin_lon_deg, first.origin_lon_deg));
    south = std::min(south, frame.origin_lat_deg);
    north = std::max(north, frame.origin_lat_deg);
  }
  out.geodetic = true;
  out.origin_lon_deg = rounded(difference_deg(first.origin_lon_deg + 0.5 * (west + east), 0));
  out.origin_lat_deg = rounded(0.5 * (south + north));
  return out;
}

std::function<Point(Point)> way_between(const LocalFrame& from, const LocalFrame& to) {
  if (!from.geodetic) {
    const Point shift{from.origin_x_m - to.origin_x_m, from.origin_y_m - to.origin_y_m};
    return [shift](Point p) { return p + shift; };
  }
  // std::function has to be copied.
  const auto away = std::make_shared<const FrameProjection>(from);
  const auto back = std::make_shared<const FrameProjection>(to);
  return [away, back](Point p) {
    const std::optional<Point> out = back->from_lonlat(away->to_lonlat(p));
    const std::optional<Point> again = out ? away->from_lonlat(back->to_lonlat(*out)) : std::nullopt;
    if (!again || distance(*again, p) > kWayBack_m)
      throw bad_input("the fields lie too far apart on earth for one file; write a file for each");
    return *out;
  };
}

}  // namespace tramline::io
