#include "tramline/cost/bound/swath_edge.h"

#include <cmath>

namespace tramline {
namespace {

/// Of the two arcs together, along the track. Beyond a displacement of 2 r the path may run straight across.
double length_of_arcs_m(const PassedPlace& place) {
  const double h = place.aside_m, r = place.arc_m;
  return h < 2 * r ? std::sqrt(h * (4 * r - h)) : 2 * r;
}

}  // namespace

double inner_edge_m(const PassedPlace& place, double away_m) {
  const double r = place.arc_m, half = 0.5 * place.width_m, inside = r - half, outside = r + half;
  const double h = place.aside_m;
  // The two arcs meet half-way down; the edge lies half a width inside them.
  const double length_m = length_of_arcs_m(place);
  const double bend_m = 0.5 * length_m * inside / r;
  if (away_m < bend_m) return h - r + std::sqrt((inside - away_m) * (inside + away_m));
  const double left_m = length_m - away_m;
  return left_m <= 0 ? -half : r - std::sqrt((outside - left_m) * (outside + left_m));
}

}  // namespace tramline
