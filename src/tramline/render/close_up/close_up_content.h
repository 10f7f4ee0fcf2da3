#pragma once
// The texts of a close-up.

#include <string>
#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/legend_content.h"

namespace tramline::render {

/// "obstacle 3 (hole 3)": its number, from 1, and its origin in the input.
std::string close_up_title(const Plan& plan, std::size_t obstacle);
std::string close_up_subtitle(const Plan& plan);

/// Symbols that occur in the box `seen`, m, and the numbers of the obstacle.
std::vector<LegendBlock> legend_of_close_up(const Plan& plan, std::size_t obstacle, const Box& seen);

/// The least distance of a track from an obstacle: half the working width and the clearance, m.
double keep_off_m(const Plan& plan);

/// "14", the strip from 1; "2/14" with the subfield before it where there are several.
std::string strip_name(const Plan& plan, std::size_t subfield, int track);

/// An encounter of a track with the obstacle as a row of the table.
struct EncounterRow {
  std::string track;
  std::string chosen;  ///< the chosen way, with the obstacles that are passed together with this one
  std::string left;    ///< cost above that of a cut, or the reason why it is not possible; for a detour that
                       ///< passes several encounters once, then a reference to that row
  std::string right;
  bool whole_line = false;  ///< `track` holds a remark that takes all columns
};

/// The rows in the order of Plan::encounters; where there are very many, the first ones and a last row that
/// counts the others.
std::vector<EncounterRow> encounter_rows(const Plan& plan, std::size_t obstacle);

}  // namespace tramline::render
