#pragma once
// The tally of one subfield's tracks for any offset of their grid, without building them.

#include <algorithm>
#include <vector>

#include "tramline/cost/grid/row_end_wedges.h"
#include "tramline/cost/tolerances.h"
#include "tramline/geometry/strip/strip_fold.h"
#include "tramline/model/tally.h"
#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline {

/// The terms shared by all grids over one subfield.
struct GridTerms {
  double width_m = 1;
  double min_length_m = 0;
  EndCriterion criterion;
};

/// A subfield and what lies around it in the turned plane of one direction.
struct TurnedSubfield {
  TrackFrame frame;
  Polygon shape;
  std::vector<Ring> outline;  ///< the rings of the shape
  TurnedGround ground;
  Box reach;                   ///< of the shape
  std::vector<Box> obstacles;  ///< of everything that is not plain land
  double area_m2 = 0;
};

/// One subfield in the turned plane of one direction. Tracks are cut at obstacles. Strips that the
/// boundary crosses plainly and that no obstacle comes near are summed in closed form;
/// the others through their profiles, and only those that obstacles come near piece by piece.
class GridTally {
 public:
  /// Precondition: the field's outer ring, where it is hard (ground.field), is that of the shape.
  GridTally(const TrackFrame& frame, const Polygon& shape, TurnedGround ground, const GridTerms& terms);

  /// The tally of the grid with line 0 at the coordinate across `origin_m`, as tally_of() for a field that is
  /// this subfield alone. O(n + K).
  Tally at(double origin_m) const;
  const TurnedSubfield& subfield() const { return subfield_; }
  const GridTerms& terms() const { return terms_; }
  /// The end rule where no obstacle comes near; at a hard boundary every swath ends inside.
  const EndCriterion& plain_criterion() const { return plain_criterion_; }
  StripGrid grid(double origin_m) const { return {subfield_.frame, origin_m, terms_.width_m}; }

 private:
  struct Sums {
    Tally tally;
    double useful_m2 = 0;
    void add(double length_m, double inside_m2, double width_m);
  };

  /// Marks the strips that obstacles come near. False where there are none.
  bool mark_obstructed(const StripGrid& grid, StripRange range, StripMask& out) const;
  /// Adds the strips that no obstacle comes near and that the boundary does not cross plainly. The fold holds
  /// them as well as those that obstacles come near.
  void add_open_strips(StripFold& fold, const StripMask& open, Sums& sums) const;
  void add_obstructed_strips(StripFold& fold, const StripGrid& grid, StripRange range,
                             const StripMask& obstructed, Sums& sums) const;
  void add_obstructed_strip(const Track& strip, const StripGrid& grid, Sums& sums) const;
  double least_length_m() const { return std::max(terms_.min_length_m, kNoPiece_m); }

  TurnedSubfield subfield_;
  GridTerms terms_;
  EndCriterion plain_criterion_;
};

}  // namespace tramline
