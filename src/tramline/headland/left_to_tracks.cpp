#include "tramline/headland/left_to_tracks.h"

#include <algorithm>

#include "tramline/geometry/boolean.h"

namespace tramline {
namespace {

/// The largest distance between two of its corners, m.
double extent_m(const Polygon& polygon) {
  double out = 0;
  for (std::size_t i = 0; i < polygon.outer.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) out = std::max(out, distance(polygon.outer[i], polygon.outer[j]));
  return out;
}

bool holds_a_track(const Polygon& polygon, double width_m, double least_length_m) {
  // Strips just as wide as the swath, and as long, shall do in spite of chords and grids.
  constexpr double kAlmost = 0.999;
  if (area(polygon) < kAlmost * kAlmost * width_m * least_length_m) return false;
  if (extent_m(polygon) < kAlmost * least_length_m) return false;
  return !buffered({polygon}, -kAlmost * 0.5 * width_m, JoinStyle::kMitre).empty();
}

void keep_tracks(Region& region, double width_m, double least_length_m) {
  std::erase_if(region, [&](const Polygon& part) { return !holds_a_track(part, width_m, least_length_m); });
}

/// Without what is narrower than the width; corners stay.
Region opened(const Region& region, double width_m) {
  constexpr double kAlmost = 0.998;
  const double half = kAlmost * 0.5 * width_m;
  return buffered(buffered(region, -half, JoinStyle::kMitre), half, JoinStyle::kMitre);
}

}  // namespace

Region left_to_tracks(const HeadlandAndBody& headland, const Region& clear, double width_m,
                      double least_length_m) {
  if (headland.uncovered_m2 < 0.99 * width_m * least_length_m) return {};
  Region left = intersection(unworked_ground(headland, width_m), clear);
  keep_tracks(left, width_m, least_length_m);
  if (left.empty()) return {};
  Region out = intersection(opened(unite(headland.body, left), width_m), left);
  keep_tracks(out, width_m, least_length_m);
  return out;
}

}  // namespace tramline
