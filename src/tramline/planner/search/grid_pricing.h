#pragma once
// What a grid over one piece of ground costs, and what no grid near it can cost less than.

#include "tramline/cost/bound/grid_bound.h"
#include "tramline/planner/candidate/candidate.h"

namespace tramline {

/// A grid by its angle and by its offset from the pivot, across.
struct GridPlace {
  double angle = 0;
  double offset_m = 0;
};

/// What a grid costs, and what it would with stops as cheap as turns: where there are ways round the
/// obstacles, few of the stops remain, and the one may rank grids wrongly where the other does not.
struct GridPrices {
  double cut = 0;
  double soft = 0;
  bool works = false;  ///< has a piece
};

/// A grid over a piece of ground, and what separate_cost() gives for it with tracks cut at obstacles.
struct PricedGrid {
  Direction direction;
  double origin_m = 0;  ///< coordinate across of line 0, in the turned plane
  double cost = 0;
};

/// Grids that lie near `middle`.
struct PlaceBox {
  GridPlace middle;
  double half_angle = 0;  ///< radians
  double half_offset_m = 0;
};

/// Everything that a grid over the part is priced with. Keeps references to the task and the part.
class GridPricing {
 public:
  GridPricing(const SearchTask& task, const Polygon& part);

  GridTally tally(double angle) const;
  static TrackFrame frame(double angle) {
    return TrackFrame(Direction::clockwise_from_north(Angle::radians(angle)));
  }
  /// Where line 0 lies in the turned plane of the tally.
  double origin(const GridTally& tally, double offset_m) const {
    return tally.subfield().frame.to_track(bound_.pivot).x + offset_m;
  }
  GridPrices prices(const GridTally& tally, double offset_m) const;
  GridPrices prices(const GridPlace& place) const { return prices(tally(place.angle), place.offset_m); }
  /// least_cost() of the box; the tally is that of its middle.
  double least(const GridTally& tally, const PlaceBox& box, double enough) const;
  PricedGrid priced(const GridPlace& place, double cost) const;

  const BoundTerms& bound() const { return bound_; }
  double width_m() const { return grid_.width_m; }
  /// No point of the part lies further from the pivot.
  double radius_m() const;
  const Polygon& part() const { return part_; }

 private:
  const SearchTask& task_;
  const Polygon& part_;
  GridTerms grid_;
  Objective soft_;
  BoundTerms bound_;
};

}  // namespace tramline
