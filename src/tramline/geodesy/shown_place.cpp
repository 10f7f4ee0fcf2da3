#include "tramline/geodesy/shown_place.h"

#include <fmt/format.h>

#include "tramline/geodesy/field_projection.h"

namespace tramline {

std::string shown_place(const LocalFrame& frame, Point local_m) {
  if (!frame.geodetic)
    return fmt::format("({:.2f}, {:.2f})", local_m.x + frame.origin_x_m, local_m.y + frame.origin_y_m);
  const Point lonlat = FrameProjection(frame).to_lonlat(local_m);
  return fmt::format("({:.7f}, {:.7f})", lonlat.x, lonlat.y);
}

}  // namespace tramline
