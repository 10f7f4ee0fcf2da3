#pragma once
// How much was applied where.

#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/cell_grid.h"
#include "tramline/model/local_frame.h"

namespace tramline {

/// Ground by how much it got.
struct DoseBin {
  double from_per_ha = 0;
  double to_per_ha = 0;  ///< infinite for the last
  double area_m2 = 0;
};

/// What the cells say together (docs/dose.md). The ground is the field, or covered ground where there is
/// none.
struct DoseFigures {
  double total = 0;             ///< applied, on the ground and off it
  double on_ground = 0;         ///< of that, on the ground
  double ground_m2 = 0;         ///< area of the ground
  double mean_per_ha = 0;       ///< on_ground by ground_m2
  double reference_per_ha = 0;  ///< the nominal rate, or the mean where there is none

  // Of cells of which half or more is ground, by how much of it they have.
  double counted_m2 = 0;       ///< the ground of these
  double cv = 0;               ///< standard deviation about the mean of these, by that mean
  double share_within_10 = 0;  ///< from 0.9 to 1.1 of the reference
  double least_per_ha = 0;
  double most_per_ha = 0;
  std::vector<DoseBin> histogram;
};

/// What the wind did.
struct DoseDrift {
  double wind_mps = 0;
  Heading wind_from;
  double share = 0;     ///< of all that was applied
  double shift_m = 0;   ///< downwind
  double spread_m = 0;  ///< standard deviation about that
};

/// Amounts in cells. Frame: local metres.
struct DoseMap {
  std::string log;
  std::string field_id;  ///< empty: no field
  Region field;          ///< less its obstacles
  LocalFrame frame;
  std::string unit;       ///< "l", "kg" …
  double width_m = 0;     ///< NaN: not known
  double covered_m2 = 0;  ///< exact, by regions

  CellGrid grid;
  std::vector<double> amount;    ///< in each cell
  std::vector<float> ground;     ///< share of each cell that is ground, 0 to 1
  std::vector<float> on_ground;  ///< of the amount in each cell, that on its ground
  DoseFigures figures;
  std::optional<DoseDrift> drift;

  double logged_amount = 0;   ///< by logged rates
  double nominal_amount = 0;  ///< by the nominal rate
  std::vector<std::string> warnings;
};

/// Amount by area of a cell, per hectare.
inline double rate_per_ha(const DoseMap& map, std::size_t cell) {
  return map.amount[cell] / map.grid.cell_area_m2() * 1e4;
}

}  // namespace tramline
