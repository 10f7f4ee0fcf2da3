#pragma once
// What a plan's cost is made of: the same areas and counts as the tally's, parted by what causes them.

#include <array>
#include <cstddef>
#include <vector>

#include "tramline/model/objective.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/laid_pieces.h"
#include "tramline/tracks/straight_tracks.h"

namespace tramline {

/// Every bit of ground that is worked in vain or left has one cause. It depends on the strip, and on the
/// row: the cross-section of the strip at one place along it. A row is full where the subfield takes up
/// all of its width, and empty where it takes up none.
///
/// What straight swaths work outside their own subfield: seams within other subfields, as far as it is
/// worked there anyway; row ends or sides beyond. What detours work, less what nothing else covers:
/// detours. What of a subfield no swath covers: the first that its row answers to of detours, stops, short
/// pieces, row ends (at a passable obstacle), seams, row ends, and sides.
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
  kHeadland,   ///< what headland passes add; nothing of the tracks
};
inline constexpr std::size_t kCauseCount = 10;

/// A boundary that takes longer than this many widths along to pass through a strip runs along it: it makes
/// less than 14 degrees with the tracks.
inline constexpr double kLongestRowEnd = 4;

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

/// A plan that has been laid out, and the ground it was laid on. Refers to its parts.
struct LaidPlan {
  const std::vector<Subfield>& subfields;
  const std::vector<TrackFamily>& families;  ///< by subfield, all of each
  const std::vector<LaidTracks>& tracks;     ///< by subfield, on these strips
  const Region& body;
  const Region& given_up;  ///< of the body; in no subfield
  const Region& passable;
  const Tally& tally;  ///< of these tracks
};

/// Closed form throughout: rows are cut at the ends of their causes, and what is left of each stretch is
/// measured between lines and arcs. O(K·n) for n edges of the body and K stretches, about three a strip.
CostCauses causes_of(const LaidPlan& plan, const Objective& objective);

}  // namespace tramline
