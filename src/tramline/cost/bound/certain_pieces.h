#pragma once
// What a strip drives in every grid of a box.

#include <span>
#include <vector>

#include "tramline/cost/bound/boundary_windows.h"
#include "tramline/geometry/interval.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {

/// Of the strips of a box of grids (grid_bound.h).
struct CertainTerms {
  double width_m = 1;
  double shift_m = 0;  ///< largest move of the boundary across
  double shear_m = 0;  ///< and along
  EndCriterion rule{};
  double least_width_m = 0;  ///< of a row that is driven
  double shortest_m = 0;     ///< piece that is driven
};

/// Rows and pieces that the end rule drives wherever the boundary moves. The rule drives rows of which enough
/// lies inside, so it drives those in which enough of the strip's left or right, or its middle, does.
class CertainPieces {
 public:
  CertainPieces() = default;
  explicit CertainPieces(const CertainTerms& terms) : terms_(terms) {}

  /// Whether a piece is driven in the windows clear of the `blocked` stretches. O(p log p).
  bool any_in(std::span<const BoundaryWindow> windows, const Intervals& blocked);
  /// The rows that are driven but for obstacles, sorted. O(p log p).
  Intervals rows_of(std::span<const BoundaryWindow> windows);

 private:
  /// A part of the boundary in a sub-strip.
  struct Crossing {
    double lowest, highest;
    bool passes_middle;
  };

  template <class Visit>
  bool any_stretch(std::span<const BoundaryWindow> windows, Interval across, const Visit& visit);
  void list_crossings(std::span<const BoundaryWindow> windows, Interval across);
  bool holds_piece(std::span<const BoundaryWindow> windows, Interval across, const Intervals& blocked);
  void append_stretches(std::span<const BoundaryWindow> windows, Interval across, Intervals& out);

  CertainTerms terms_;
  std::vector<Crossing> crossings_;
};

}  // namespace tramline
