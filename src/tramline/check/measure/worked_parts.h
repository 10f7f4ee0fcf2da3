#pragma once
// The swaths of a plan in parts that are easily laid over one another.

#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Ground worked along one line: a straight swath with its detours, or a part of one, a segment of a curved
/// swath, or a cell of one with kinks.
struct WorkedPart {
  std::size_t piece = 0;  ///< or the headland pass, counted on after the pieces
  Path line;
  Region ground;        ///< arcs as chords
  bool kinked = false;  ///< one of the cells between kinks: convex
  /// How far the swath turns to either side up to the part and to its end, rad. Where it jumps or turns too
  /// tightly to lie flat that counts as half a circle.
  double turned_before = 0;
  double turned_after = 0;
};

/// All swaths in the order of the pieces, each from its start to its end; straight ones whole. O(n).
std::vector<WorkedPart> worked_parts(const Plan& plan);
/// The ground of headland passes, segment by segment, on to the owners after the pieces: pass k is owner
/// pieces + k. O(n).
std::vector<WorkedPart> pass_parts(const Plan& plan, double sagitta_m = kChordSagitta);
/// As worked_parts(), and straight ones parted where detours begin and end, which may lie over the rest.
std::vector<WorkedPart> parts_between_detours(const Plan& plan);

/// False where the two have no ground in common for certain, or none that shows (kThinnestShown_m): their
/// lines are too far apart, or follow one another in one swath within a quarter turn. There all headings are
/// within 45° of one, along which a swath no tighter than half its width only goes forwards.
bool may_meet(const WorkedPart& earlier, const WorkedPart& later, double width_m);

}  // namespace tramline::check
