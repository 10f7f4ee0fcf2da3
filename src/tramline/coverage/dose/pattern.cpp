#include "tramline/coverage/dose/pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

void require_points(const SprayPattern& points, const std::string& place) {
  if (points.size() < 2)
    throw bad_input(
        fmt::format("{} has {} points: a pattern needs two, such as its ends", place, points.size()));
  for (const PatternPoint& point : points) {
    if (!std::isfinite(point.offset_m))
      throw bad_input(fmt::format("{}: an offset is no finite number of metres", place));
    if (!std::isfinite(point.rate) || point.rate < 0)
      throw bad_input(fmt::format("{}: the rate at {:g} m is {}; rates are 0 or more", place, point.offset_m,
                                  point.rate));
  }
}

/// From right to left.
SprayPattern in_order(SprayPattern points, const std::string& place) {
  if (points.front().offset_m > points.back().offset_m) std::reverse(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].offset_m < points[i - 1].offset_m)
      throw bad_input(
          fmt::format("{}: offsets have to go from one side to the other, but {:g} m and {:g} m do not",
                      place, points[i - 1].offset_m, points[i].offset_m));
    if (i > 1 && points[i].offset_m == points[i - 2].offset_m)
      throw bad_input(fmt::format("{}: {:g} m is there three times", place, points[i].offset_m));
  }
  return points;
}

double value_at(const PatternStretch& stretch, double offset_m) {
  const double share = (offset_m - stretch.right_m) / (stretch.left_m - stretch.right_m);
  return std::max(0.0, (1 - share) * stretch.at_right + share * stretch.at_left);
}

}  // namespace

TransversePattern::TransversePattern() = default;

TransversePattern::TransversePattern(SprayPattern points, double width_m, const std::string& place) {
  require_points(points, place);
  const SprayPattern sorted = in_order(std::move(points), place);
  double whole = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const PatternPoint& a = sorted[i - 1];
    const PatternPoint& b = sorted[i];
    if (!(b.offset_m > a.offset_m)) continue;
    stretches_.push_back({a.offset_m, b.offset_m, a.rate, b.rate});
    whole += 0.5 * (a.rate + b.rate) * (b.offset_m - a.offset_m);
  }
  // Below that digits are lost, and the factor is no number.
  constexpr double kLeast = 1e-200;
  if (!(whole > kLeast) || !std::isfinite(whole))
    throw bad_input(fmt::format("{}: nothing lands anywhere; give rates above 0", place));
  for (PatternStretch& stretch : stretches_) {
    stretch.at_right *= width_m / whole;
    stretch.at_left *= width_m / whole;
  }
}

double TransversePattern::right_m() const { return stretches_.empty() ? 0 : stretches_.front().right_m; }
double TransversePattern::left_m() const { return stretches_.empty() ? 0 : stretches_.back().left_m; }

std::vector<PatternStretch> TransversePattern::within(double right_m, double left_m) const {
  assert(right_m < left_m);
  if (even()) return {{right_m, left_m, 1, 1}};
  std::vector<PatternStretch> out;
  for (const PatternStretch& stretch : stretches_) {
    const double from = std::max(right_m, stretch.right_m), to = std::min(left_m, stretch.left_m);
    if (from < to) out.push_back({from, to, value_at(stretch, from), value_at(stretch, to)});
  }
  return out;
}

}  // namespace tramline::coverage
