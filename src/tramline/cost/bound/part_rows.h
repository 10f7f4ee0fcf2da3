#pragma once
// The rows of a strip, grouped by the parts of the boundary that pass through them.

#include <algorithm>
#include <span>
#include <vector>

#include "tramline/cost/bound/strip_parts.h"

namespace tramline {

/// Whether the part runs up the strip. The region lies on its left.
inline bool rises(const BoundaryPart& part) { return part.to.y > part.from.y; }
/// Coordinate across where the line through a part, which must not lie along the row, passes the row.
inline double x_at(const BoundaryPart& part, double along) {
  return part.from.x + (part.to.x - part.from.x) * ((along - part.from.y) / (part.to.y - part.from.y));
}

/// A stretch along a strip in which each row is passed by the same parts, none of which passes a line of
/// the strip there.
struct PartRow {
  double from = 0, to = 0;                ///< coordinates along
  double inside_from = 0, inside_to = 0;  ///< length of the row inside the region at either end, m
  std::span<const BoundaryPart* const> parts;
};

/// Lists such stretches. Kept and reused, for its memory.
class PartRows {
 public:
  /// Calls row(const PartRow&) from low to high for every stretch that a part passes. `parts` are sorted by
  /// their lowest coordinate; `cuts` are further coordinates along at which a stretch ends. O(p log p +
  /// p·(most parts in a row)).
  template <class Row>
  void for_each(std::span<const BoundaryPart> parts, double width_m, std::span<const double> cuts,
                const Row& row) {
    list_ends(parts, width_m, cuts);
    active_.clear();
    auto next = parts.begin();
    for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
      const double from = ends_[i], to = ends_[i + 1], middle = 0.5 * (from + to);
      if (!(from < to)) continue;
      std::erase_if(active_, [&](const BoundaryPart* part) { return part->highest() <= middle; });
      for (; next != parts.end() && next->lowest() <= from; ++next)
        if (next->highest() > middle) active_.push_back(&*next);
      if (active_.empty()) continue;
      row(active_.size() == 1 ? row_of(*active_.front(), from, to, width_m) : row_of_all(from, to, width_m));
    }
  }

 private:
  void list_ends(std::span<const BoundaryPart> parts, double width_m, std::span<const double> cuts);
  PartRow row_of(const BoundaryPart& part, double from, double to, double width_m) const {
    const double at_from = std::clamp(x_at(part, from), 0.0, width_m);
    const double at_to = std::clamp(x_at(part, to), 0.0, width_m);
    if (rises(part)) return {from, to, at_from, at_to, active_};
    return {from, to, width_m - at_from, width_m - at_to, active_};
  }
  PartRow row_of_all(double from, double to, double width_m) const;

  std::vector<double> ends_;
  std::vector<const BoundaryPart*> active_;
};

}  // namespace tramline
