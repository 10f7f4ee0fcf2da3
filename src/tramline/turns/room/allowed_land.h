#pragma once
// Is there room for what a machine sweeps when it turns?

#include <limits>
#include <vector>

#include "tramline/turns/outline/outline.h"
#include "tramline/turns/room/land_edges.h"

namespace tramline {

/// Land on which the outline of a turning machine may be. Built once, and safe to use from any number of
/// threads.
class AllowedLand {
 public:
  /// The field less its obstacles, and what may be swept beyond soft boundaries. Polygons of the region must
  /// not touch: what passes from one to the other leaves the land. O(n).
  explicit AllowedLand(const Region& land);

  /// Whether the outline stays on the land all along the path: exactly on lines and arcs, up to
  /// kTouchesEdge_m beyond the edges, so that it may touch them. On clothoids, and for an implement that
  /// swings behind its drawbar, motion is bounded piece by piece by even ones, as finely as it takes: an
  /// outline on the land is never refused, and none is accepted that leaves it by more than kBoundedMotion_m.
  /// An empty path needs no room. A drawbar points along the machine at the start of the path, and paths of
  /// outlines that tow have no reverse (TowedMotion). O(edges near the path) for lines and arcs.
  bool fits(const SteeredPath& path, const Outline& outline) const;

  /// The same, up to kBoundedMotion_m beyond the edges on lines and arcs too: for paths that lead along an
  /// edge, give or take the rounding of both.
  bool nearly_fits(const SteeredPath& path, const Outline& outline) const;

  /// fits() in parts, where nothing is towed and a path is lines and arcs: the outline is on the land in the
  /// path's first pose, and leaves it on none of the stretches, each by itself.
  bool holds(const Pose& pose, const Outline& outline) const;
  /// Preconditions: the outline is on the land where the stretch starts; no clothoid; nothing is towed.
  bool never_leaves(const SteeredStretch& stretch, const Outline& outline) const;

  /// The greatest distance from the land of a point of the outline on its way, m: how much room is missing.
  /// 0 where it fits; otherwise found to kMissingRoom_m by bounding (the distance from the land changes by no
  /// more than a point moves), and rather too little than too much. For reports: O(n) for each of up to
  /// 30 000 places. Where it is `enough_m` or more, the answer may be less than it, but is `enough_m` at
  /// least. Where ways are only compared, the share `roughly` of it may be too little: that takes a fraction
  /// of the places.
  double missing_m(const SteeredPath& path, const Outline& outline,
                   double enough_m = std::numeric_limits<double>::infinity(), double roughly = 0) const;

  /// The land as given, oriented.
  const Region& land() const { return land_; }
  /// Its edges, moved outwards by kTouchesEdge_m.
  const LandEdges& edges() const { return exact_; }

 private:
  Region land_;
  LandEdges exact_;    ///< moved outwards by kTouchesEdge_m
  LandEdges bounded_;  ///< moved outwards by kBoundedMotion_m
};

}  // namespace tramline
