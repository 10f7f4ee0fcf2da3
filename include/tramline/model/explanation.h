#pragma once
// Why a plan was chosen: what its cost is made of, and what the next best plans would have cost.

#include <array>
#include <cstddef>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/objective.h"
#include "tramline/model/tally.h"

namespace tramline {

/// The cause of overlap or uncovered land. Every part of either has exactly one cause. The cause depends on
/// the strip and on the row, which is the cross-section of the strip at one position along it. A row is full
/// where the subfield takes up its whole width, and empty where it takes up none.
/// What straight swaths work outside their own subfield counts as seams where another subfield's swaths work
/// it anyway, and as row ends or sides elsewhere. What detours work, less the land that nothing else covers,
/// counts as detours. Land of a subfield that no swath covers counts as the first of these that applies to
/// its row: detours, stops, short pieces, row ends (at a passable obstacle), seams, row ends, sides.
enum class Cause {
  /// The boundary passes through the strip: rows between a full one and an empty one, over no more than
  /// kLongestRowEnd widths; and rows into which a passable obstacle reaches.
  kRowEnds,
  kSides,        ///< the boundary runs along the strip: all other rows
  kSeams,        ///< rows into which another subfield reaches
  kDetours,      ///< rows between the ends of a detour
  kStops,        ///< rows into which obstacles or given-up land reach; and the stops themselves
  kShortPieces,  ///< rows of pieces that were too short to drive
  kGivenUp,      ///< land given up
  kTurns,
  kSubfields,  ///< every subfield after the first
  kHeadland,   ///< what headland passes add, without anything of the tracks
};
inline constexpr std::size_t kCauseCount = 10;

/// row ends, sides, seams, detours, stops, short pieces, given up, turns, subfields, headland
const char* name(Cause cause);

struct CausePart {
  double overlap_m2 = 0;
  double uncovered_m2 = 0;
  int count = 0;    ///< of turns, stops or further subfields; 0 for other causes
  double cost = 0;  ///< of all three
};

/// The parts sum to the tally and to its cost, up to the rounding of the sums.
struct CostCauses {
  std::array<CausePart, kCauseCount> parts;  ///< by Cause
  /// By how much the areas, each measured by itself, sum to less than the tally's: what the precision grid
  /// of polygons moves, and strips thinner than the width tolerance. The largest part holds it already.
  double overlap_rounding_m2 = 0;
  double uncovered_rounding_m2 = 0;

  const CausePart& of(Cause cause) const { return parts[static_cast<std::size_t>(cause)]; }
};

/// What a plan costs above another one; negative where it costs less, by what is paid for.
struct CostDifference {
  double overlap = 0;
  double uncovered = 0;
  double turns = 0;
  double stops = 0;
  double subfields = 0;

  double sum() const { return overlap + uncovered + turns + stops + subfields; }
};

CostDifference difference(const Objective& objective, const Tally& of, const Tally& from);

/// overlap, uncovered, turns, stops or subfields: what is largest; among equals the first.
const char* main_reason(const CostDifference& more);

/// A plan that was not chosen.
struct RunnerUp {
  std::vector<Direction> directions;  ///< of the subfields that have tracks
  Tally tally;
  double cost = 0;
  CostDifference more;  ///< than the chosen plan
};

struct Explanation {
  CostCauses causes;                 ///< of the chosen plan, headland passes included
  std::vector<RunnerUp> runner_ups;  ///< cheapest first
  RunnerUp longest_side;             ///< the ground undivided, with tracks along the field's longest side
};

}  // namespace tramline
