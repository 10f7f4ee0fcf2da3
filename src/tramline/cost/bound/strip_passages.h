#pragma once
// How a strip gets past the obstacles in it.

#include <vector>

#include "tramline/cost/bound/boundary_windows.h"
#include "tramline/cost/bound/detour_zones.h"
#include "tramline/model/objective.h"

namespace tramline {

/// Of a box of grids (grid_bound.h).
struct PassageTerms {
  const Objective& objective;
  double width_m = 0;
  double shift_m = 0;  ///< largest move of the boundary across
  double shear_m = 0;  ///< and along
  double tangent = 0;  ///< of the largest turn
  double detour_reach_m = 0;
};

/// The obstacles of one strip after the other, for every grid of a box.
class StripPassages {
 public:
  /// All outlive this. The zones are those of the obstacles (detour_zones()).
  StripPassages(const TurnedSubfield& subfield, const std::vector<DetourZone>& zones,
                const PassageTerms& terms);

  /// Makes a strip the current one. The rows in which an obstacle may be in the way, from low to high.
  Intervals enter(const StripGrid& grid, int strip);

  /// Least cost of getting past the obstacles of the current strip between the pieces that are driven for
  /// certain: a cut, or the rows in between and what a detour is longer (docs/bounds.md). One detour may pass
  /// several of them. `pooled`: the rows that detours may work; `windows`: of the boundary in the strip.
  double cost(const Intervals& driven, const Intervals& pooled,
              const std::vector<BoundaryWindow>& windows) const;

 private:
  /// A hole of the land, which is an obstacle.
  struct Hole {
    const Ring* ring;
    Box box;
  };

  /// The part of a hole in the current strip.
  struct HoleRows {
    Interval rows;        ///< where it may reach into the strip
    int edges = 0;        ///< edges that may
    bool blocks = false;  ///< whether it does, in every grid
    const Hole* hole = nullptr;
  };

  HoleRows rows_of(const Hole& hole, double left, double right) const;
  double longer_round(const Hole& hole) const;
  bool only_holes_in(const Interval& between, const std::vector<BoundaryWindow>& windows) const;

  const TurnedSubfield& subfield_;
  const std::vector<DetourZone>& zones_;
  PassageTerms terms_;
  std::vector<Hole> holes_;
  // Of the current strip:
  double left_ = 0, centre_ = 0, right_ = 0;
  std::vector<HoleRows> rows_;
};

}  // namespace tramline
