#pragma once
// How a strip gets past the obstacles in it.

#include <array>
#include <optional>
#include <vector>

#include "tramline/cost/bound/boundary_windows.h"
#include "tramline/cost/bound/detour_zones.h"
#include "tramline/cost/bound/row_cost_bound.h"
#include "tramline/cost/bound/ways_past_obstacle.h"
#include "tramline/model/objective.h"

namespace tramline {

/// Of a box of grids (grid_bound.h).
struct PassageTerms {
  const Objective& objective;
  double width_m = 0;
  double shift_m = 0;      ///< largest move of the boundary across
  double shear_m = 0;      ///< and along
  double tangent = 0;      ///< of the largest turn
  RowBoundTerms moving{};  ///< by how much rows move across
  double detour_reach_m = 0;
  const std::vector<bool>& at_obstacle;  ///< BoundTerms::at_obstacle
  bool drivable = true;                  ///< BoundTerms::drivable
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
  /// `windows`: of the boundary in the strip. Obstacles that stand alone in their zone are kept for
  /// cost_together().
  double cost(const Intervals& driven, const Intervals& zones, const Intervals& pooled,
              const std::vector<BoundaryWindow>& windows);

  /// Least cost of getting all strips so far past the obstacles that were kept, with the land that their
  /// detours leave.
  double cost_together() const;

  /// Ends of the strip, 0 to 2, at which an obstacle stops the last piece whatever detours there are: the
  /// boundary from the last piece driven for certain to the obstacle has obstacles beyond it, and the strip
  /// ends too soon for the way back of a detour.
  int stops_at_ends(const Intervals& driven, const std::vector<BoundaryWindow>& windows) const;

 private:
  struct Obstacle {
    const Ring* ring;
    Box box;
    const DetourZone* alone = nullptr;  ///< its zone, where it is the only obstacle there
    std::vector<StripAtObstacle> strips{};
    bool together = true;  ///< whether all strips that it may reach into are among them, each once
  };

  /// The part of an obstacle in the current strip.
  struct ObstacleRows {
    Interval rows;        ///< where it may reach into the strip
    bool blocks = false;  ///< whether it does, in every grid
    Obstacle* obstacle = nullptr;
    bool is_known = false;  ///< whether it lies between pieces that are driven for certain
  };

  /// A detour round an obstacle on one side of it.
  struct Way {
    bool fits = true;     ///< whether there may be room for it
    double longer_m = 0;  ///< by which it is longer than its rows, at least
    Point past{};         ///< the obstacle's farthest point, and by how much it is displaced there, at least
    double aside_m = 0;
    double slack_m = 0;        ///< by which the place of its largest displacement may lie elsewhere along
    bool is_farthest = false;  ///< whether no other place is displaced as far
    void meet(const Way& other);
  };
  struct WaysRound {
    Way left, right;
    /// What a detour goes round on the left, and on the right, of the last obstacle.
    std::array<std::vector<Point>, 2> passed{};
    Interval in_strip{};  ///< rows in which the obstacle is in the strip in every grid
    bool any() const { return left.fits || right.fits; }
  };

  /// A stretch between two pieces that obstacles block.
  struct Passage {
    bool blocked = false;  ///< whether any is in the way in every grid
    double cut = 0;        ///< what it costs to cut the track
    double rows_m = 0;     ///< between the pieces
    WaysRound ways;
    ObstacleRows* alone = nullptr;  ///< its obstacle, where that is the only one in its zone
  };

  std::optional<ObstacleRows> rows_of(Obstacle& obstacle) const;
  WaysRound ways_round(const Obstacle& obstacle, const Interval& piece, const Interval& land) const;
  Interval rows_of_detour(const DetourZone& zone, double most_aside_m) const;
  double rows_to_leave_m(double aside_m) const;
  double turned_m(const Box& box) const;
  const DetourZone* zone_of(const Obstacle& obstacle) const;
  double shift_at(const Obstacle& obstacle) const;
  void keep(const Passage& passage, const std::vector<BoundaryWindow>& windows) const;
  Interval clear_rows(const Obstacle& obstacle, const std::vector<BoundaryWindow>& windows) const;
  bool comes_near(const Obstacle& obstacle, const DetourZone& other) const;
  double cost_past(const Obstacle& obstacle) const;
  Interval land_in(const std::vector<BoundaryWindow>& windows) const;
  bool only_obstacles_in(double from, double to, const std::vector<BoundaryWindow>& windows) const;

  const std::vector<DetourZone>& zones_;
  PassageTerms terms_;
  Box reach_;
  std::vector<Obstacle> obstacles_;
  // Of the current strip:
  double left_ = 0, centre_ = 0, right_ = 0;
  std::vector<ObstacleRows> rows_;
};

}  // namespace tramline
