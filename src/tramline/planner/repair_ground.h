#pragma once
// The ground of a repair, and the lines that are best for a part of it.

#include <optional>
#include <string>

#include "tramline/model/field.h"
#include "tramline/planner/gap_grids.h"

namespace tramline {

/// Missed ground that a repair leaves.
struct LeftGap {
  int number = 0;  ///< of the gap in the coverage, from 1
  double area_m2 = 0;
  Point at;  ///< within it
  std::string why;
};

/// Smaller polygons are what the precision grid makes of two edges that should be one, m².
inline constexpr double kNoGround_m2 = 1e-4;

/// Where the lines of a repair may lie, and what they are laid for. Frame: the field's local metres.
struct RepairGround {
  Region free;       ///< the field less its obstacles, oriented
  Region obstacles;  ///< passable strips too
  RepairTerms terms;
  double min_area_m2 = 0;  ///< smaller ground is left
};

RepairGround repair_ground(const Field& field, const RepairTerms& terms, double min_area_m2);

/// A part of the missed ground with what lies about it.
GapGround ground_of(Region region, const RepairGround& ground);

/// The lines that cost least, as in best_lines(), among those that cover as much as is no gap any more when
/// it is left, or enough for the rest to be none; nullopt: no such line.
std::optional<GapChoice> chosen_lines(const GapGround& part, const RepairGround& ground, GapEffort effort);
/// The same in every direction, and then for ground however narrow.
std::optional<GapChoice> lines_whatever_it_takes(const GapGround& part, const RepairGround& ground);

/// Why chosen lines are none.
std::string why_unreachable(const RepairGround& ground);

/// The polygons of at least that area.
Region sized(Region region, double least_m2);

}  // namespace tramline
