#include "tramline/io/log/settle_positions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/geodesy/crs.h"
#include "tramline/geometry/error.h"
#include "tramline/io/fixes/places.h"

namespace tramline::io {
namespace {

/// Extent of the middle 98 in a hundred: a few damaged records do not count.
double span(const std::vector<Fix>& fixes, double Point::*axis) {
  std::vector<double> values;
  for (const Fix& fix : fixes) values.push_back(fix.position.*axis);
  const auto cut = std::ssize(values) / 100;
  std::nth_element(values.begin(), values.begin() + cut, values.end());
  const double low = values[static_cast<std::size_t>(cut)];
  std::nth_element(values.begin(), values.end() - 1 - cut, values.end());
  return *(values.end() - 1 - cut) - low;
}

bool look_like_metres(const std::vector<Fix>& fixes) {
  if (fixes.empty()) return false;
  const auto impossible = std::count_if(fixes.begin(), fixes.end(), [](const Fix& fix) {
    return std::abs(fix.position.x) > 180 || std::abs(fix.position.y) > 90;
  });
  return impossible * 100 > std::ssize(fixes) || span(fixes, &Point::y) > kWidestLog_deg ||
         span(fixes, &Point::x) > kWidestLog_deg;
}

/// False where a corner has no place.
bool project(Polygon& shape, const Crs& crs) {
  const auto project_ring = [&](Ring& ring) {
    for (Point& corner : ring) {
      const auto lonlat = crs.to_lonlat(corner);
      if (!lonlat) return false;
      corner = *lonlat;
    }
    return true;
  };
  return project_ring(shape.outer) && std::all_of(shape.holes.begin(), shape.holes.end(), project_ring);
}

void project(WorkLog& log, const Crs& crs) {
  skip_faulty(log, [&](Fix& fix) {
    const auto lonlat = crs.to_lonlat(fix.position);
    if (!lonlat) return fmt::format("{}, {} is no place in {}", fix.position.x, fix.position.y, crs.name());
    fix.position = *lonlat;
    if (fix.shape >= 0 && !project(log.shapes[static_cast<std::size_t>(fix.shape)], crs))
      return fmt::format("a corner of it is no place in {}", crs.name());
    return std::string();
  });
}

}  // namespace

void settle_positions(WorkLog& log, PositionNames names, const std::string& crs, const std::string& place) {
  log.positions = Positions::kLonLat;
  const bool any = !log.fixes.empty();
  if (!crs.empty()) {
    const Crs given(crs);
    if (given.plain())
      log.positions = Positions::kLocal;
    else if (!given.in_degrees() || given.definition() != "EPSG:4326")
      project(log, given);
  } else if (names == PositionNames::kMetres ||
             (names == PositionNames::kEither && look_like_metres(log.fixes))) {
    log.positions = Positions::kLocal;
    log.notes.emplace_back("x and y are taken as plain metres; --log-crs would place them on the earth");
  }
  if (log.positions == Positions::kLonLat) {
    skip_faulty(log, [](const Fix& fix) { return fault_of_lonlat(fix.position); });
    skip_strays(log);
  }
  if (any && log.fixes.empty())
    throw bad_input(
        fmt::format("{} has no possible position: {}; name the CRS of the positions with --log-crs, or "
                    "--log-crs none for plain metres",
                    place, log.skipped.listed.back().why));
}

}  // namespace tramline::io
