#include "tramline/cost/bound/vacated_land.h"

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

/// Of the two arcs together, along the track. Beyond a displacement of 2 r the path may run straight across.
double length_of_arcs_m(const PassedPlace& place) {
  const double h = place.aside_m, r = place.arc_m;
  return h < 2 * r ? std::sqrt(h * (4 * r - h)) : 2 * r;
}

/// How far beside the track's line the inner edge of the swath lies, `away_m` along the track from the place.
/// The path's two arcs meet half-way down; the edge lies half a width inside them.
double inner_edge(const PassedPlace& place, double away_m) {
  const double r = place.arc_m, half = 0.5 * place.width_m, inside = r - half, outside = r + half;
  const double h = place.aside_m;
  const double length_m = length_of_arcs_m(place);
  const double bend_m = 0.5 * length_m * inside / r;
  if (away_m < bend_m) return h - r + std::sqrt((inside - away_m) * (inside + away_m));
  const double left_m = length_m - away_m;
  return left_m <= 0 ? -half : r - std::sqrt((outside - left_m) * (outside + left_m));
}

/// ∫ of what lies between the strip's far side and the swath's inner edge, from `from_m` to `to_m` away.
double vacated_between(const PassedPlace& place, double from_m, double to_m) {
  constexpr int kSteps = 16;
  double sum = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double away_m = from_m + (to_m - from_m) * i / kSteps + place.slack_m;
    sum += std::clamp(inner_edge(place, away_m) + 0.5 * place.width_m, 0.0, place.width_m);
  }
  return sum * (to_m - from_m) / kSteps;
}

}  // namespace

double vacated_m2(const PassedPlace& place, const Intervals& rows) {
  const double reach_m = length_of_arcs_m(place);
  double sum = 0;
  for (const Interval& stretch : rows) {
    const auto add = [&](double from_m, double to_m) {
      from_m = std::max(from_m, 0.0);
      to_m = std::min(to_m, reach_m);
      if (from_m < to_m) sum += vacated_between(place, from_m, to_m);
    };
    add(stretch.from - place.along, stretch.to - place.along);
    add(place.along - stretch.to, place.along - stretch.from);
  }
  return sum;
}

}  // namespace tramline
