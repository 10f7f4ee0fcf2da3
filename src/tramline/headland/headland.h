#pragma once
// Headlands: the passes round the field and its obstacles, the ground they work, and the body they leave
// (Zhou §2.3.3; headlands that meet or overlap, which Zhou leaves open, are one).

#include <vector>

#include "tramline/model/field.h"
#include "tramline/model/headland.h"

namespace tramline {

/// The terms of headlands. One machine works all of them.
struct HeadlandTerms {
  double width_m = 3;                ///< working width, > 0
  double radius_m = 6;               ///< turning radius, ≥ 0
  int field_passes = 0;              ///< round the boundary; 0: the field has no headland
  std::vector<int> obstacle_passes;  ///< by Field::obstacles; 0, also where the list ends early: the obstacle
                                     ///< has no headland. Of no consequence for passable ones
  double min_length_m = 0;           ///< no track is shorter
  HeadlandConstruction construction = HeadlandConstruction::kDrivable;
  /// By edges of Field::outer, edge i from vertex i to vertex i + 1; empty: field_passes along all of them,
  /// else field_passes does not count. Different numbers require kDrivable.
  std::vector<int> edge_passes{};
  double clearance_m = 0;  ///< land kept free round obstacles that are not passable, ≥ 0

  bool operator==(const HeadlandTerms&) const = default;
};

/// Headlands, except for Headland::unworked, and the body they leave.
struct HeadlandAndBody : Headland {
  Region body;  ///< what the tracks have to cover; empty where headlands take the whole field
};

/// With HeadlandConstruction::kPlain as plain_headland_of(). Else pass i runs (i − ½)·w from the boundaries
/// that have that many passes, and from obstacles the clearance farther; the headland is as many widths deep,
/// with the clearance, which no pass works. It keeps half a width from the last pass of other boundaries, or
/// from the obstacle where that has none. Round a corner that stands out into the land it runs along an arc
/// at that distance, and swings wide where that would be tighter than the machine can turn; into all others
/// it goes as far as the machine can turn.
///
/// Boundaries whose swaths with one number would meet are driven round together. In a passage too narrow to
/// turn in, both sides are driven, corners rounded as elsewhere, where that is possible and works more ground
/// for the first time than again. A lobe where the machine cannot turn is left out, and so is a ring that
/// would for the most part follow boundaries whose passes are all driven already.
///
/// Ground that no pass works is body where a track fits: at least a width from every boundary that has a
/// headland (no swath leaves the field there, however it ends) and the clearance, as wide as a swath, and as
/// long as the least length or two widths, whichever is more. The rest counts as uncovered.
///
/// With different numbers by edge, as many passes as all edges have go round the field. Each further pass
/// runs along every chain of edges that have it, without regard to the others, as an open path: round corners
/// as above, and at the ends of the chain straight on until its swath reaches the boundary, an obstacle, or a
/// pass driven before. Where that is farther off than twice the pass's depth (the field widens, or hardly
/// turns) the pass ends at right angles to the chain. The headland is the land along the chains
/// (chain_ground.h). Parts of the body beside it without room for a track go to it.
///
/// No pass leaves the field or enters an obstacle with its swath (up to 1e-6 m; where an open pass is driven
/// straight on to its end, up to 1e-4 m to its sides). Passable obstacles do not bend passes. Ground inside a
/// hole of an obstacle is body without headland.
///
/// O(n²) for n corners, less where they are far apart compared to the distances.
/// Preconditions: edge_passes is empty or has a number for each edge.
HeadlandAndBody headland_of(const Field& field, const HeadlandTerms& terms);

/// `uncovered_m2` as a region: the ground that no pass works, exact to about kBodySagitta at arcs. Unworked
/// area on passable obstacles is included neither here nor in uncovered_m2: they are not ground. A polygon
/// difference for each pass: mostly slower than headland_of.
Region unworked_ground(const Headland& headland, double width_m);
/// The same with other chords, exact to about `sagitta_m` at arcs.
Region unworked_ground(const Headland& headland, double width_m, double sagitta_m);

/// The most passes round the field (obstacles without headland) that leave any body at all. O(log) bodies.
int most_passes(const Field& field, double width_m);

}  // namespace tramline
