#include "tramline/geometry/polygon/significant_vertices.h"

#include <algorithm>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// Between the kept vertices first and last, counted on beyond the ring's end.
void keep_between(const Ring& ring, std::size_t first, std::size_t last, double tolerance_m,
                  std::vector<bool>& kept) {
  const std::size_t n = ring.size();
  double farthest = tolerance_m;
  std::size_t at = last;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off = distance_to_segment(ring[i % n], ring[first % n], ring[last % n]);
    if (off > farthest) {
      farthest = off;
      at = i;
    }
  }
  if (at == last) return;
  kept[at % n] = true;
  keep_between(ring, first, at, tolerance_m, kept);
  keep_between(ring, at, last, tolerance_m, kept);
}

}  // namespace

std::vector<std::size_t> significant_vertices(const Ring& ring, double tolerance_m) {
  const auto along_diagonal = [](Point a, Point b) { return a.x + a.y < b.x + b.y; };
  const auto ends = std::minmax_element(ring.begin(), ring.end(), along_diagonal);
  auto first = static_cast<std::size_t>(ends.first - ring.begin());
  auto last = static_cast<std::size_t>(ends.second - ring.begin());
  if (first > last) std::swap(first, last);
  std::vector<bool> kept(ring.size(), false);
  kept[first] = kept[last] = true;
  keep_between(ring, first, last, tolerance_m, kept);
  keep_between(ring, last, first + ring.size(), tolerance_m, kept);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) out.push_back(i);
  return out;
}

Polygon simplified(const Polygon& polygon, double tolerance_m) {
  const auto through_significant = [tolerance_m](const Ring& ring) {
    Ring out;
    for (const std::size_t i : significant_vertices(ring, tolerance_m)) out.push_back(ring[i]);
    return out.size() < 3 ? ring : out;
  };
  Polygon out{through_significant(polygon.outer), {}};
  for (const Ring& hole : polygon.holes) out.holes.push_back(through_significant(hole));
  if (find_invalidity(out)) return polygon;
  return out;
}

}  // namespace tramline
