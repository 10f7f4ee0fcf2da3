#include "tramline/cost/bound/strip_parts.h"

#include <algorithm>

namespace tramline {
namespace {

/// The part of a → b, whose x grows from `low` to `high` or fall, between left and right.
BoundaryPart clipped(Point a, Point b, std::size_t edge, double left, double right) {
  const auto cut = [&](Point p) {
    const double x = std::clamp(p.x, left, right);
    return x == p.x ? p : Point{x, a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x))};
  };
  return {cut(a), cut(b), edge};
}

}  // namespace

void StripParts::collect(const std::vector<Ring>& outline, const StripGrid& grid, StripRange range,
                         double margin_m) {
  parts_.clear();
  strip_.clear();
  first_.assign(static_cast<std::size_t>(range.size()) + 1, 0);
  std::size_t edge = 0;
  for (const Ring& ring : outline) {
    Point a = ring.back();
    for (const Point b : ring) {
      const int low = std::max(grid.strip_at(std::min(a.x, b.x) - margin_m), range.first);
      const int high = std::min(grid.strip_at(std::max(a.x, b.x) + margin_m), range.last);
      for (int k = low; k <= high; ++k) {
        const double line = grid.line(k);
        parts_.push_back(
            clipped({a.x - line, a.y}, {b.x - line, b.y}, edge, -margin_m, grid.width_m + margin_m));
        strip_.push_back(k - range.first);
        ++first_[static_cast<std::size_t>(k - range.first) + 1];
      }
      a = b;
      ++edge;
    }
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  sorted_.resize(parts_.size());
  for (std::size_t i = parts_.size(); i-- > 0;)
    sorted_[--first_[static_cast<std::size_t>(strip_[i]) + 1]] = parts_[i];
  // Each first_[k + 1] has been counted down to the start of strip k.
  first_.erase(first_.begin());
  first_.push_back(parts_.size());
}

}  // namespace tramline
