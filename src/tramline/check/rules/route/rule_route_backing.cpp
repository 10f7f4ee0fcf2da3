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
/// No machine backs along what it has driven longer ago, m.
constexpr double kLookedBack_m = 20000;

/// How far places are off the lines of legs, each at its nearest.
class OffLines {
 public:
  explicit OffLines(const SteeredPath& path) {
    for (const CoursePlace& place : course_of(path, kBackedBy_m)) {
      places_.push_back(place.place.at);
      off_m_.push_back(std::numeric_limits<double>::infinity());
    }
  }

  void look_at(const SteeredPath& line) {
    const std::vector<CoursePlace> along = course_of(line, kPoses_m);
    for (std::size_t i = 0; i < places_.size(); ++i)
      for (std::size_t k = 0; k + 1 < along.size() && off_m_[i] > kLengthTolerance_m; ++k)
        off_m_[i] =
            std::min(off_m_[i], distance_to_segment(places_[i], along[k].place.at, along[k + 1].place.at));
  }

  double farthest_m() const { return *std::max_element(off_m_.begin(), off_m_.end()); }

 private:
  std::vector<Point> places_;
  std::vector<double> off_m_;
};

bool is_along_work(const RouteLeg& leg) { return leg.work || leg.pass.has_value(); }

/// How far a leg gets off what was driven before it.
double off_driven_m(const std::vector<RouteLeg>& legs, std::size_t leg) {
  OffLines off(legs[leg].path);
  double looked_m = 0;
  for (std::size_t i = leg; i > 0 && looked_m <= kLookedBack_m && off.farthest_m() > kLengthTolerance_m;
       --i) {
    off.look_at(legs[i - 1].path);
    looked_m += length(legs[i - 1]);
  }
  return off.farthest_m();
}

/// How far it gets off the works behind it without a way between.
double off_works_behind_m(const std::vector<RouteLeg>& legs, std::size_t leg) {
  OffLines off(legs[leg].path);
  for (std::size_t i = leg + 1; i < legs.size() && is_along_work(legs[i]); ++i) off.look_at(legs[i].path);
  return off.farthest_m();
}

}  // namespace

void check_route_backing(const Case& c, Violations& out) {
  const std::vector<RouteLeg>& legs = c.plan.route.legs;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].kind != LegKind::kBackOut) continue;
    const double off_m = std::min(off_driven_m(legs, i), off_works_behind_m(legs, i));
    if (off_m > kLengthTolerance_m)
      out.push_back({Rule::kRouteLegs,
                     fmt::format("{} does not lead along what was driven before it or is worked behind it",
                                 leg_name(c.plan, i)),
                     legs[i].path.front().start.at, std::isfinite(off_m) ? off_m : length(legs[i])});
  }
}

}  // namespace tramline::check
