#pragma once
// Where a machine gets on convex land without a change of gear, by its heading.

#include <cstddef>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Headings are told apart by sectors, the first from 0 (along x) anticlockwise.
inline constexpr std::size_t kHeadingSectors = 72;

/// Places of a machine that points into a sector of headings, by sector.
struct PlacesByHeading {
  std::vector<Ring> places;   ///< convex polygons that hold all of them; empty: none
  std::vector<Ring> on_land;  ///< of these, where the machine is on the land
  bool followed = true;       ///< false: it gets to so many headings that none is ruled out
};

/// Whether a machine may be at one place and in one sector of both.
bool may_meet(const PlacesByHeading& a, const PlacesByHeading& b);
/// Whether one of the places may be on the line, and point as the line's machine does there.
bool may_meet(const PlacesByHeading& places, const SteeredPath& line);
/// Whether the machine may be at this place and point as there.
bool may_meet(const PlacesByHeading& places, const Pose& pose);

/// Follows a machine over all ways that it may drive on convex land, from one sector of headings to the next.
///
/// Between the headings that bound a sector, δ apart, it gets on by 2 r sin(δ/2) along the middle of the
/// sector at least, and within the sector in no direction but those of the sector. Where it passes a bounding
/// heading, all corners of its outline have to be on the land. The convex hulls of the places that it gets to
/// so, grown until none grows any more, hold all places it can reach.
class HeadingReach {
 public:
  /// A half plane: the land lies where dot(p − at, inwards) ≥ 0.
  struct Side {
    Point at;
    Point inwards;  ///< unit vector
  };

  /// `corners`: of the outline, the axle at the origin and pointing along x. Preconditions: the sides bound
  /// the land, radius_m > 0.
  HeadingReach(std::vector<Side> sides, const std::vector<Point>& corners, double radius_m);

  /// By driving on from the pose, forward (`sense` +1) or in reverse (-1). What leads to the pose forward is
  /// what it would get to in reverse. O(sectors · rounds until nothing grows · sides).
  PlacesByHeading from(const Pose& pose, double sense) const;

 private:
  enum class Turn { kLeft, kRight };
  /// Where it points along the lower bound of a sector.
  struct AtBound {
    Point at;
    std::size_t bound;
  };

  PlacesByHeading followed_from(const Pose& pose, double sense) const;
  Ring on_land(Ring places, const std::vector<double>& from_side_m) const;
  bool stands_on_land(Point at, std::size_t bound) const;
  /// On to the next bound, as sharply as it can turn.
  AtBound turned(const AtBound& from, double sense, Turn turn) const;
  bool can_circle(AtBound from, double sense, Turn turn) const;
  bool can_circle_ahead(const AtBound& from, double sense) const;
  /// Whether it gets to all headings on a turn to one side, a straight and a circle.
  bool can_turn_round(const Pose& pose, double sense) const;

  std::vector<Side> sides_;
  double radius_m_;
  double far_m_ = 0;                             ///< more than the land is wide
  std::vector<std::vector<double>> at_bound_m_;  ///< by lower bound of a sector and side: the least distance
  std::vector<std::vector<double>> in_sector_m_;
};

}  // namespace tramline
