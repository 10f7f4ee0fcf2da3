#pragma once
// The cost of a grid over one part of the land, and a lower bound for all grids near it.

#include "tramline/cost/bound/grid_bound.h"
#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/search_context.h"

namespace tramline {

/// A grid, given by its angle and its offset from the pivot across the tracks.
struct GridPosition {
  double angle = 0;
  double offset_m = 0;
};

/// The cost of a grid with all tracks cut, and its cost with stops as cheap as turns. Where there are ways
/// round the obstacles few of the stops remain, and then the first may rank grids wrongly where the second
/// does not.
struct GridPrices {
  double cut = 0;
  double soft = 0;
  bool works = false;  ///< whether it has a piece
};

/// A grid over a part of the land, and its separate_cost() with tracks cut at obstacles.
struct PricedGrid {
  Direction direction;
  double origin_m = 0;  ///< coordinate of line 0 across the tracks, in the turned plane
  double cost = 0;
};

/// The grids within half_angle and half_offset_m of `middle`.
struct PositionBox {
  GridPosition middle;
  double half_angle = 0;  ///< radians
  double half_offset_m = 0;
};

/// Prices grids over the part. Keeps a reference to the task.
class GridPricing {
 public:
  /// Exactly where the search proves a bound. Else over an outline with fewer vertices, which deviates from
  /// the part by a small share of the working width: most vertices of land behind headlands lie on arcs.
  GridPricing(const SearchTask& task, const Polygon& part, const SearchContext& context,
              NearObstacles near = NearObstacles::kNothing);

  GridTally tally(double angle) const;
  static TrackFrame frame(double angle) {
    return TrackFrame(Direction::clockwise_from_north(Angle::radians(angle)));
  }
  /// The coordinate of line 0 in the turned plane of the tally.
  double origin(const GridTally& tally, double offset_m) const {
    return tally.subfield().frame.to_track(bound_.pivot).x + offset_m;
  }
  GridPrices prices(const GridTally& tally, double offset_m) const;
  GridPrices prices(const GridPosition& position) const {
    return prices(tally(position.angle), position.offset_m);
  }
  /// least_cost() of the box; `tally` is that of its middle.
  double least(const GridTally& tally, const PositionBox& box, double enough) const;
  PricedGrid priced(const GridPosition& position, double cost) const;

  const BoundTerms& bound() const { return bound_; }
  double width_m() const { return grid_.width_m; }
  /// The largest distance of a point of the part from the pivot.
  double radius_m() const;
  const Polygon& part() const { return part_; }

 private:
  const SearchTask& task_;
  Polygon part_;
  GridTerms grid_;
  Objective soft_;
  BoundTerms bound_;
};

/// By what share of its cost an offset may be dearer than the best one.
inline double near_enough(const SearchContext& context) { return context.wants_bound() ? 0 : 0.01; }

}  // namespace tramline
