#pragma once
// The best grid of lines for missed ground.

#include <optional>
#include <vector>

#include "tramline/planner/gap_lines.h"

namespace tramline {

/// How hard to look.
enum class GapEffort {
  kGlance,    ///< the directions of the ground as a whole
  kLook,      ///< its longer edges too, and those of the field beside it
  kThorough,  ///< and every 7.5 degrees
};

/// Directions worth trying, in a fixed order, no two within a tenth of a degree. But for a thorough look none
/// leads more than 10° off the length of a gap that is narrower than w and at least three times as long as
/// wide: such a gap is worked along.
std::vector<Direction> gap_directions(const GapGround& ground, double width_m, GapEffort effort);

/// Those of the directions that lead along all gaps narrower than w and three times as long as wide.
std::vector<Direction> along_narrow_gaps(const GapGround& ground, double width_m,
                                         const std::vector<Direction>& directions);

/// Whether lines much shorter than the longest of their grid are driven.
enum class ShortLines { kLeave, kDrive };

/// The lines chosen of one grid.
struct GapChoice {
  GapLines lines;
  double price = 0;  ///< of the lines, and of what they leave: see best_lines()
};

/// The grid over all the directions and some twenty offsets in each whose lines cost least, together with
/// what they leave. Lines much shorter than the longest may be left for another direction, priced as if what
/// they meet was worked along; what lies in no line is priced high, for it needs another line at least.
/// nullopt where no grid has a line that covers `least_m2`. Deterministic. O(directions · offsets) looks at
/// the ground.
std::optional<GapChoice> best_lines(const GapGround& ground, const std::vector<Direction>& directions,
                                    const RepairTerms& terms, double least_m2, double least_width_m,
                                    ShortLines short_lines);

}  // namespace tramline
