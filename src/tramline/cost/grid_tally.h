#pragma once
// What the tracks of one subfield amount to for any offset of their grid, without building them.

#include <vector>

#include "tramline/cost/plain_ends.h"
#include "tramline/model/tally.h"
#include "tramline/tracks/strip_pieces.h"

namespace tramline {

/// What all grids over one subfield share.
struct GridTerms {
  double width_m = 1;
  double min_length_m = 0;
  EndCriterion criterion;
};

/// One subfield in the turned plane of one direction. Tracks are cut at obstacles. Strips that the
/// boundary crosses plainly and that no obstacle comes near are summed in closed form (ALGORITHMS §0.1);
/// the others through their profiles.
class GridTally {
 public:
  /// Precondition: the field's outer ring, where it is hard (ground.field), is that of the shape.
  GridTally(const TrackFrame& frame, const Polygon& shape, TurnedGround ground, const GridTerms& terms);

  /// Of the grid with line 0 at the coordinate across `origin_m`: with tally_of's meaning for a field
  /// that is this subfield alone. O(n + K).
  Tally at(double origin_m) const;
  /// Of the subfield in its turned plane.
  const Box& reach() const { return reach_; }

 private:
  StripGrid grid(double origin_m) const { return {frame_, origin_m, terms_.width_m}; }
  /// Those that obstacles come near.
  void mark_obstructed(const StripGrid& grid, StripRange range, StripMask& out) const;

  TrackFrame frame_;
  Polygon shape_;
  std::vector<Ring> outline_;
  TurnedGround ground_;
  GridTerms terms_;
  EndCriterion plain_criterion_;
  Box reach_;
  std::vector<Box> obstacles_;  ///< all that is not plain ground
  double area_m2_ = 0;
};

}  // namespace tramline
