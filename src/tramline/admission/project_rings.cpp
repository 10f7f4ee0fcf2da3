#include "tramline/admission/project_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tramline {

std::string ring_name(std::size_t index) { return index == 0 ? "outer ring" : fmt::format("hole {}", index); }

std::string coordinate_fault(Point input, const Crs& crs) {
  if (!std::isfinite(input.x) || !std::isfinite(input.y))
    return fmt::format("has the coordinates ({}, {}), which are not finite numbers", input.x, input.y);
  if (!crs.in_degrees()) return {};
  if (std::abs(input.y) > 90)
    return fmt::format(
        "has the latitude {:.10g}, beyond 90 degrees; give the CRS of the coordinates with --crs", input.y);
  if (std::abs(input.x) > 180)
    return fmt::format(
        "has the longitude {:.10g}, beyond 180 degrees; give the CRS of the coordinates with --crs", input.x);
  return {};
}

void check_coordinates(const RawPolygon& part, const Crs& crs, const std::string& subject) {
  for (std::size_t r = 0; r < part.rings.size(); ++r)
    for (std::size_t i = 0; i < part.rings[r].points.size(); ++i) {
      const std::string fault = coordinate_fault(part.rings[r].points[i], crs);
      if (!fault.empty())
        throw bad_input(fmt::format("{}: {}, vertex {} {}", subject, ring_name(r), i + 1, fault));
    }
}

void check_not_degrees(const Box& bounds, const Crs& crs, const std::string& subject) {
  if (crs.in_degrees()) return;
  const bool on_globe =
      bounds.min_x >= -180 && bounds.max_x <= 180 && bounds.min_y >= -90 && bounds.max_y <= 90;
  const double extent = std::max(bounds.width(), bounds.height());
  if (on_globe && extent > 0 && extent < 1)
    throw bad_input(fmt::format("{}: the coordinates look like degrees but count as {}; give --crs EPSG:4326",
                                subject, crs.plain() ? "plain metres, as no CRS is named" : crs.name()));
}

WorkRing project_ring(const RawRing& ring, const std::string& name, RepairLog& repair_log) {
  WorkRing out;
  out.name = name;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const std::optional<Point> local = repair_log.projection().to_local(ring.points[i]);
    if (!local)
      throw repair_log.refusal(
          fmt::format("{}, vertex {} at {} lies outside {}; give the right CRS with --crs", name, i + 1,
                      shown_coordinates(ring.points[i], repair_log.projection().crs()),
                      repair_log.projection().crs().name()));
    out.points.push_back(*local);
    out.vertex.push_back(static_cast<int>(i) + 1);
  }
  if (!ring.closed && out.points.size() >= 3)
    repair_log.repair(fmt::format("{} was not closed; its last vertex was joined to its first", name),
                      out.place(out.points.size() - 1), out.points.back(), 0);
  return out;
}

}  // namespace tramline
