#pragma once
// How a strip gets past the obstacles in it.

#include <optional>
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
  const std::vector<bool>& at_obstacle;  ///< BoundTerms::at_obstacle
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
  /// several of them. `zones`: the rows in which detours may run; `pooled`: those that they may work;
  /// `windows`: of the boundary in the strip.
  double cost(const Intervals& driven, const Intervals& zones, const Intervals& pooled,
              const std::vector<BoundaryWindow>& windows) const;

  /// Ends of the strip, 0 to 2, at which an obstacle stops the last piece whatever detours there are: the
  /// boundary from the last piece driven for certain to the obstacle has obstacles beyond it, and the strip
  /// ends too soon for the way back of a detour.
  int stops_at_ends(const Intervals& driven, const std::vector<BoundaryWindow>& windows) const;

 private:
  struct Obstacle {
    const Ring* ring;
    Box box;
  };

  /// The part of an obstacle in the current strip.
  struct ObstacleRows {
    Interval rows;        ///< where it may reach into the strip
    bool blocks = false;  ///< whether it does, in every grid
    const Obstacle* obstacle = nullptr;
  };

  /// A detour round an obstacle on one side of it.
  struct Way {
    bool fits = true;     ///< whether there may be room for it
    double longer_m = 0;  ///< by which it is longer than its rows, at least
    Point past{};         ///< the obstacle's farthest point, and by how much it is displaced there, at least
    double aside_m = 0;
    double slack_m = 0;  ///< by which the place of its largest displacement may lie elsewhere along
    void meet(const Way& other);
  };
  struct WaysRound {
    Way left, right;
    bool any() const { return left.fits || right.fits; }
  };

  /// A stretch between two pieces that obstacles block.
  struct Passage {
    double cut = 0;     ///< what it costs to cut the track
    double rows_m = 0;  ///< between the pieces
    WaysRound ways;
    const ObstacleRows* alone = nullptr;  ///< the obstacle, where no detour of other strips comes near it
  };

  std::optional<ObstacleRows> rows_of(const Obstacle& obstacle) const;
  WaysRound ways_round(const Obstacle& obstacle, const Interval& piece, const Interval& land) const;
  double turned_m(const Obstacle& obstacle) const;
  bool is_alone(const ObstacleRows& rows) const;
  double vacated(const Way& way, const std::vector<BoundaryWindow>& windows) const;
  Interval land_in(const std::vector<BoundaryWindow>& windows) const;
  bool blocks_within(double from, double to) const;
  bool only_obstacles_in(double from, double to, const std::vector<BoundaryWindow>& windows) const;

  const std::vector<DetourZone>& zones_;
  PassageTerms terms_;
  std::vector<Obstacle> obstacles_;
  // Of the current strip:
  double left_ = 0, centre_ = 0, right_ = 0;
  std::vector<ObstacleRows> rows_;
};

}  // namespace tramline
