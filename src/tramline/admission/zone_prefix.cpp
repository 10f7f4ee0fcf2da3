#include "tramline/admission/zone_prefix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/geometry/error.h"

namespace tramline {
namespace {

constexpr double kPrefixUnit_m = 1e6;
constexpr double kPlainFalseEasting_m = 500000;
// A zone is at most 6° wide, so eastings stay within 400 km of the central meridian.
constexpr double kZoneHalfWidth_m = 400000;

template <class Visit>
void for_each_point(RawFeature& feature, Visit visit) {
  for (RawPolygon& polygon : feature.polygons)
    for (RawRing& ring : polygon.rings)
      for (Point& p : ring.points) visit(p);
  for (auto& line : feature.lines)
    for (Point& p : line) visit(p);
  for (Point& p : feature.points) visit(p);
}

/// The zone number in front of the easting; 0 for none, -1 for an easting that fits no zone.
int zone_of(double easting) {
  if (!std::isfinite(easting)) return -1;
  const double zone = std::round((easting - kPlainFalseEasting_m) / kPrefixUnit_m);
  if (zone < 0 || zone > 120) return -1;
  const double rest = easting - zone * kPrefixUnit_m - kPlainFalseEasting_m;
  return std::abs(rest) <= kZoneHalfWidth_m ? static_cast<int>(zone) : -1;
}

/// Numbers that the zone with this central meridian goes by: UTM (6°), Gauss-Krüger in 6° and 3°.
bool zone_matches(int zone, double meridian) {
  const auto is = [zone](double number) { return std::abs(number - zone) < 1e-6; };
  return is((meridian + 183) / 6) || is((meridian + 3) / 6) || is(meridian / 3);
}

}  // namespace

std::optional<double> zone_prefix_m(const RawFeature& feature, const Crs& crs, const std::string& subject) {
  if (!crs.grid() || crs.grid()->false_easting_m != kPlainFalseEasting_m) return std::nullopt;
  RawFeature copy = feature;
  int zone = 0;
  bool first = true, same = true;
  for_each_point(copy, [&](Point p) {
    const int here = zone_of(p.x);
    same = same && (first || here == zone);
    zone = here;
    first = false;
  });
  if (!same || zone <= 0) return std::nullopt;
  if (!zone_matches(zone, crs.grid()->central_meridian_deg))
    throw bad_input(
        fmt::format("{}: the eastings carry zone {} but the CRS is {}; give the right one with --crs",
                    subject, zone, crs.name()));
  return zone * kPrefixUnit_m;
}

RawFeature without_prefix(RawFeature feature, double prefix_m) {
  for_each_point(feature, [prefix_m](Point& p) { p.x -= prefix_m; });
  return feature;
}

}  // namespace tramline
