#pragma once
// Where a machine gets on convex land without a change of gear: facts of the rule about the bound of a route.

#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::check {

/// Convex regions, by sector of headings, that hold all places a machine gets to while it points there.
struct DrivenPlaces {
  bool everywhere = false;   ///< it can turn round, and no more is known
  std::vector<Ring> in{};    ///< by sector; empty: nowhere
  std::vector<Ring> room{};  ///< of these, with room for the outline
};

/// From place to place of a line, without turning by more than half a sector.
struct LineStep {
  Pose from, to;
};

/// Whether a machine may be at one place of both, pointing into the same sector, to 5 cm.
bool may_be_common(const DrivenPlaces& a, const DrivenPlaces& b);
/// Whether one of the places may lie on the line, pointing as the machine does there, to 5 cm.
bool may_be_on(const std::vector<LineStep>& line, const DrivenPlaces& places);

/// The half planes that the land lies in, and the outline that has to stay in them at every heading that is a
/// multiple of 5°. To turn from one of these to the next takes a machine 2 r sin 2.5° along the heading
/// halfway at least; in between it drives on in some heading from the one to the other.
class ConvexLand {
 public:
  struct Edge {
    Point on;
    Point inwards;  ///< unit vector
  };
  /// `corners`: of the outline, ahead of the axle and to its left, m. Preconditions: edges bound the land,
  /// there are corners, radius_m > 0.
  ConvexLand(std::vector<Edge> edges, std::vector<Point> corners, double radius_m);

  /// By driving forward (+1) or backing (-1) from a place: all regions grow, heading by heading, until a
  /// round of all headings adds nothing.
  DrivenPlaces driven_from(const Pose& at, double sense) const;

  /// What of a region leaves room for the outline at a heading, in sectors, or turned from it by so much,
  /// rad.
  Ring with_room(Ring region, double heading, double turned) const;
  double radius_m() const { return radius_m_; }
  double beyond_m() const { return beyond_m_; }

 private:
  std::vector<Edge> edges_;
  std::vector<Point> corners_;
  double radius_m_;
  double beyond_m_ = 0;  ///< farther than across the land
  double reach_m_ = 0;   ///< of the corners
};

}  // namespace tramline::check
