#include "tramline/coverage/drive/log_hole.h"

#include <algorithm>
#include <cmath>

#include "tramline/coverage/drive/course.h"

namespace tramline::coverage {
namespace {

constexpr double kDriving_mps = 0.3;
constexpr double kEnough_s = 10;

bool leads_along(const std::optional<Heading>& heading, Heading way) {
  return !heading || dot(heading->unit(), way.unit()) >= std::cos(kStraightOn.radians());
}

bool is_plausible(const HoleEnd& from, const HoleEnd& to, Heading way, double usual_mps) {
  const bool straight_on = leads_along(from.heading, way) && leads_along(to.heading, way);
  const double seconds = to.time_s - from.time_s;
  if (std::isnan(seconds)) return straight_on;
  const double speed_mps = distance(from.position, to.position) / seconds;  // infinite in no time
  if (std::isnan(usual_mps)) return straight_on && speed_mps <= kFastestWork_mps;
  return speed_mps <= kMostOfUsual * usual_mps && (straight_on || speed_mps >= kLeastOfUsual * usual_mps);
}

Boom in_both(const Boom& a, const Boom& b) {
  Boom out;
  for (const Section& one : a)
    for (const Section& other : b) {
      const Section common{std::min(one.left_m, other.left_m), std::max(one.right_m, other.right_m)};
      if (common.left_m > common.right_m) out.push_back(common);
    }
  return out;
}

}  // namespace

void UsualSpeed::add(double way_m, double seconds) {
  if (!(way_m >= kDriving_mps * seconds)) return;  // not without times either
  way_m_ += way_m;
  seconds_ += seconds;
}

double UsualSpeed::mps() const {
  return seconds_ >= kEnough_s ? way_m_ / seconds_ : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Quad> hole_strip(const HoleEnd& from, const HoleEnd& to, double usual_mps, QuadShape quads) {
  if (distance(from.position, to.position) < kLeastStep_m) return {};
  const Heading way = Heading::from_to(from.position, to.position);
  if (!is_plausible(from, to, way, usual_mps)) return {};
  const auto across = [&](const HoleEnd& end) {
    const bool fits = quads == QuadShape::kHeading && end.heading && leads_along(end.heading, way);
    return left_of((fits ? *end.heading : way).unit());
  };
  const Point rear = across(from), front = across(to);
  std::vector<Quad> out;
  for (const Section& section : in_both(from.working, to.working))
    out.push_back({from.position + section.left_m * rear, from.position + section.right_m * rear,
                   to.position + section.right_m * front, to.position + section.left_m * front});
  return out;
}

}  // namespace tramline::coverage
