#pragma once
// The swaths of a plan in parts that are suited for overlays.

#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Land worked along one line: a straight swath with its detours or a part of it, a segment of a curved
/// swath, or a cell of a swath with kinks.
struct WorkedPart {
  std::size_t piece = 0;  ///< index of the piece; for headland pass k the number of pieces plus k
  Path line;
  Region ground;        ///< arcs as chords
  bool kinked = false;  ///< whether it is one of the (convex) cells between kinks
  /// Sum of all angles, to the left or to the right alike, through which the swath has turned by the
  /// beginning of the part and by its end, rad. A jump in heading, or a turn too tight to lie flat, adds half
  /// a circle.
  double turned_before = 0;
  double turned_after = 0;
};

/// All swaths in the order of the pieces, each from its start to its end; straight ones whole. O(n).
std::vector<WorkedPart> worked_parts(const Plan& plan);
/// The bands of a headland pass, segment by segment: with flat ends even at kinks, but of lines of others cut
/// to kinks like tracks.
Region pass_bands(const Plan& plan, const HeadlandPass& pass, double sagitta_m);
/// The parts of headland passes, segment by segment; pass k has the owner index pieces + k. O(n).
std::vector<WorkedPart> pass_parts(const Plan& plan, double sagitta_m = kChordSagitta);
/// As worked_parts(), with straight swaths divided where detours begin and end; a detour may overlap the
/// rest.
std::vector<WorkedPart> parts_between_detours(const Plan& plan);

/// Whether the two parts may overlap visibly (kThinnestShown_m). They do not where their lines are too far
/// apart, or where they follow one another in one swath within a quarter turn: there all headings are within
/// 45° of one direction, along which a swath no tighter than half its width only goes forwards.
bool may_meet(const WorkedPart& earlier, const WorkedPart& later, double width_m);

}  // namespace tramline::check
