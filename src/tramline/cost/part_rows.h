#pragma once
// The rows of a strip, by the parts of the boundary that pass through them.

#include <algorithm>
#include <span>
#include <vector>

#include "tramline/cost/strip_parts.h"

namespace tramline {

/// A stretch along a strip in which each row is passed by the same parts, none of which passes a line of
/// the strip there.
struct PartRow {
  double from = 0, to = 0;                ///< coordinates along
  double inside_from = 0, inside_to = 0;  ///< how much of the row lies inside at either end, m
  std::span<const BoundaryPart* const> parts;
};

/// The same for any parts of one strip; made once and used again, so that the memory is reused.
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
      const bool right = right_inside(middle);
      row(PartRow{from, to, inside_width(from, width_m, right), inside_width(to, width_m, right), active_});
    }
  }

 private:
  void list_places(std::span<const BoundaryPart> parts, double width_m, std::span<const double> cuts);
  /// Does the land to the right of all parts that pass the row lie inside?
  bool right_inside(double along) const;
  double inside_width(double along, double width_m, bool right) const;

  std::vector<double> places_;
  std::vector<const BoundaryPart*> active_;
};

}  // namespace tramline
