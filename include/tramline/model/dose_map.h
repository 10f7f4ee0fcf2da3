#pragma once
// A map of the amount applied, and the pattern across the machine in which it is.

#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/cell_grid.h"
#include "tramline/model/local_frame.h"

namespace tramline {

/// A relative rate at an offset across the machine. Between two points the rate changes linearly; beyond the
/// outermost points it is 0. Two points at one offset are a jump.
struct PatternPoint {
  double offset_m = 0;  ///< from the machine's middle, positive to the left
  double rate = 0;      ///< relative: only ratios count
};

/// The points from right to left or from left to right.
using SprayPattern = std::vector<PatternPoint>;

/// One bin of the histogram: the area that received a rate within its limits.
struct DoseBin {
  double from_per_ha = 0;
  double to_per_ha = 0;  ///< infinite for the last bin
  double area_m2 = 0;
};

/// Statistics over all cells (docs/dose.md). Ground is the land of the field or, without a
/// field, covered land.
struct DoseFigures {
  double total = 0;             ///< amount applied, on the ground and off it
  double on_ground = 0;         ///< the part of it on the ground
  double ground_m2 = 0;         ///< area of the ground
  double mean_per_ha = 0;       ///< on_ground / ground_m2
  double reference_per_ha = 0;  ///< the nominal rate, or the mean where there is none

  // Over the cells of which half or more is ground, weighted by the area of their ground.
  double counted_m2 = 0;       ///< area of ground in these cells
  double cv = 0;               ///< coefficient of variation: their standard deviation / their mean
  double share_within_10 = 0;  ///< share of the area with 0.9 to 1.1 times the reference
  double least_per_ha = 0;
  double most_per_ha = 0;
  std::vector<DoseBin> histogram;
};

/// Drift by the wind.
struct DoseDrift {
  double wind_mps = 0;
  Heading wind_from;
  double share = 0;     ///< share of the applied amount that drifts
  double shift_m = 0;   ///< downwind
  double spread_m = 0;  ///< standard deviation about the shift
};

/// The amount applied in each cell. Frame: local metres.
struct DoseMap {
  std::string log;
  std::string field_id;  ///< empty: no field
  Region field;          ///< less its obstacles
  LocalFrame frame;
  std::string unit;       ///< "l", "kg" …
  double width_m = 0;     ///< NaN: not known
  double covered_m2 = 0;  ///< covered area, exact (from regions, not from cells)

  CellGrid grid;
  std::vector<double> amount;    ///< applied in each cell
  std::vector<float> ground;     ///< share of each cell that is ground, 0 to 1
  std::vector<float> on_ground;  ///< the part of each cell's amount that lies on its ground
  DoseFigures figures;
  std::optional<DoseDrift> drift;

  double logged_amount = 0;   ///< applied at logged rates
  double nominal_amount = 0;  ///< applied at the nominal rate
  std::vector<std::string> warnings;
};

/// The rate in a cell: amount per hectare.
inline double rate_per_ha(const DoseMap& map, std::size_t cell) {
  return map.amount[cell] / map.grid.cell_area_m2() * 1e4;
}

}  // namespace tramline
