#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

/// Places along a leg that backs out are so far apart, m.
constexpr double kBackedBy_m = 1;

bool is_along_work(const RouteLeg& leg) { return leg.work || leg.pass.has_value(); }

/// The axle's places along the works that lie before a leg, or behind it, without a way between: the nearest
/// place first.
std::vector<Point> works_beside(const std::vector<RouteLeg>& legs, std::size_t leg, std::ptrdiff_t step) {
  std::vector<Point> out;
  const auto count = static_cast<std::ptrdiff_t>(legs.size());
  for (auto i = static_cast<std::ptrdiff_t>(leg) + step; i >= 0 && i < count; i += step) {
    const RouteLeg& beside = legs[static_cast<std::size_t>(i)];
    if (!is_along_work(beside)) break;
    std::vector<CoursePlace> places = course_of(beside.path, kPoses_m);
    if (step < 0) std::reverse(places.begin(), places.end());
    for (const CoursePlace& place : places) out.push_back(place.place.at);
  }
  return out;
}

/// How far the leg gets off a line, m; infinite where there is none.
double off_line_m(const SteeredPath& path, const std::vector<Point>& line) {
  if (line.size() < 2) return std::numeric_limits<double>::infinity();
  double off_m = 0;
  for (const CoursePlace& place : course_of(path, kBackedBy_m)) {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      least_m = std::min(least_m, distance_to_segment(place.place.at, line[i], line[i + 1]));
    off_m = std::max(off_m, least_m);
  }
  return off_m;
}

}  // namespace

void check_route_backing(const Case& c, Violations& out) {
  const std::vector<RouteLeg>& legs = c.plan.route.legs;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].kind != LegKind::kBackOut) continue;
    const double off_m = std::min(off_line_m(legs[i].path, works_beside(legs, i, -1)),
                                  off_line_m(legs[i].path, works_beside(legs, i, +1)));
    if (off_m > kLengthTolerance_m)
      out.push_back(
          {Rule::kRouteLegs,
           fmt::format("{} does not lead along the works before it or behind it", leg_name(c.plan, i)),
           legs[i].path.front().start.at, std::isfinite(off_m) ? off_m : length(legs[i])});
  }
}

}  // namespace tramline::check
