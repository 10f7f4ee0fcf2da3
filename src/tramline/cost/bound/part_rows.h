#pragma once
// The rows of a strip, by the parts of the boundary that pass through them.

#include <algorithm>
#include <span>
#include <vector>

#include "tramline/cost/bound/strip_parts.h"

namespace tramline {

/// What lies to the left of a part is inside: does it run up the strip?
inline bool rises(const BoundaryPart& part) { return part.to.y > part.from.y; }
/// Where the line through a part that does not lie across passes a row.
inline double x_at(const BoundaryPart& part, double along) {
  return part.from.x + (part.to.x - part.from.x) * ((along - part.from.y) / (part.to.y - part.from.y));
}

/// A stretch along a strip in which each row is passed by the same parts, none of which passes a line of
/// the strip there.
struct PartRow {
  double from = 0, to = 0;                ///< coordinates along
  double inside_from = 0, inside_to = 0;  ///< how much of the row lies inside at either end, m
  std::span<const BoundaryPart* const> parts;
};

/// Lists such stretches; made once and used again, so that the memory is reused.
class PartRows {
 public:
  /// Calls row(const PartRow&) from low to high for every stretch that is passed at all. `parts` are sorted
  /// by their lowest place; `cuts` are places along at which a stretch ends besides.
  /// O(p log p + p·(most parts in a row)).
  template <class Row>
  void for_each(std::span<const BoundaryPart> parts, double width_m, std::span<const double> cuts,
                const Row& row) {
    list_places(parts, width_m, cuts);
    active_.clear();
    auto next = parts.begin();
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      const double from = places_[i], to = places_[i + 1], middle = 0.5 * (from + to);
      if (!(from < to)) continue;
      std::erase_if(active_, [&](const BoundaryPart* part) { return part->highest() <= middle; });
      for (; next != parts.end() && next->lowest() <= from; ++next)
        if (next->highest() > middle) active_.push_back(&*next);
      if (active_.empty()) continue;
      row(active_.size() == 1 ? row_of(*active_.front(), from, to, width_m) : row_of_all(from, to, width_m));
    }
  }

 private:
  void list_places(std::span<const BoundaryPart> parts, double width_m, std::span<const double> cuts);
  PartRow row_of(const BoundaryPart& part, double from, double to, double width_m) const {
    const double at_from = std::clamp(x_at(part, from), 0.0, width_m);
    const double at_to = std::clamp(x_at(part, to), 0.0, width_m);
    if (rises(part)) return {from, to, at_from, at_to, active_};
    return {from, to, width_m - at_from, width_m - at_to, active_};
  }
  PartRow row_of_all(double from, double to, double width_m) const;

  std::vector<double> places_;
  std::vector<const BoundaryPart*> active_;
};

}  // namespace tramline
