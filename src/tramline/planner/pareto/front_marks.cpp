#include "tramline/planner/pareto/front_marks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/planner/pareto/dominance.h"

namespace tramline {
namespace {

using Scaled = std::array<double, 3>;

Scaled criteria(const Tally& tally) {
  return {tally.overlap_m2, tally.uncovered_m2, static_cast<double>(turns_and_stops(tally))};
}

std::vector<Scaled> scaled_points(const Front& front) {
  std::vector<Scaled> out;
  for (const FrontPoint& point : front.points) out.push_back(criteria(point.tally));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] = std::minmax_element(
        out.begin(), out.end(), [axis](const Scaled& a, const Scaled& b) { return a[axis] < b[axis]; });
    const double low = (*least)[axis], extent = (*most)[axis] - low;
    for (Scaled& point : out) point[axis] = extent > 0 ? (point[axis] - low) / extent : 0;
  }
  return out;
}

double dot(const Scaled& a, const Scaled& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Scaled minus(const Scaled& a, const Scaled& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Scaled cross(const Scaled& a, const Scaled& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The normal of the plane through three points, not of unit length, turned so that it has no negative
/// component; (0, 0, 0) where that cannot be.
Scaled normal_of(const Scaled& a, const Scaled& b, const Scaled& c) {
  Scaled normal = cross(minus(b, a), minus(c, a));
  if (dot(normal, {1, 1, 1}) < 0) normal = minus({0, 0, 0}, normal);
  const bool good = *std::min_element(normal.begin(), normal.end()) >= 0;
  return good ? normal : Scaled{};
}

template <class Key>
std::size_t least_by(const Front& front, Key key) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < front.points.size(); ++i)
    if (std::pair(key(front.points[i].tally), front.points[i].cost) <
        std::pair(key(front.points[best].tally), front.points[best].cost))
      best = i;
  return best;
}

}  // namespace

std::size_t cheapest_for(const Front& front, const Objective& prices) {
  assert(!front.points.empty());
  std::size_t best = 0;
  for (std::size_t i = 1; i < front.points.size(); ++i)
    if (cost(prices, front.points[i].tally) < cost(prices, front.points[best].tally)) best = i;
  return best;
}

std::size_t knee_of(const Front& front) {
  assert(!front.points.empty());
  const std::vector<Scaled> points = scaled_points(front);
  const Scaled& corner = points[front.marks.least_overlap];
  const Scaled normal =
      normal_of(corner, points[front.marks.least_uncovered], points[front.marks.fewest_turns]);
  const bool plane = dot(normal, corner) > 0;
  std::size_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = plane ? dot(normal, points[i]) : dot(points[i], points[i]);
    if (distance >= nearest) continue;
    nearest = distance;
    best = i;
  }
  return best;
}

std::vector<std::size_t> points_to_show(const Front& front, double step) {
  const std::vector<Scaled> points = scaled_points(front);
  std::vector<std::size_t> out = marked_points(front);
  const auto near_one_shown = [&](std::size_t i) {
    return std::any_of(out.begin(), out.end(), [&](std::size_t shown) {
      const Scaled apart = minus(points[i], points[shown]);
      return std::all_of(apart.begin(), apart.end(), [step](double d) { return std::abs(d) < step; });
    });
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!near_one_shown(i)) out.push_back(i);
  std::sort(out.begin(), out.end());
  return out;
}

FrontMarks marks_for(const Front& front) {
  assert(!front.points.empty());
  Front marked = front;
  FrontMarks& marks = marked.marks;
  marks.least_overlap =
      least_by(front, [](const Tally& tally) { return criteria_of(tally).overlap_milli_m2; });
  marks.least_uncovered =
      least_by(front, [](const Tally& tally) { return criteria_of(tally).uncovered_milli_m2; });
  marks.fewest_turns = least_by(front, [](const Tally& tally) { return turns_and_stops(tally); });
  marks.given_prices = cheapest_for(front, front.prices);
  marks.knee = knee_of(marked);
  return marks;
}

}  // namespace tramline
