#pragma once
// Maps of one field in several directions and at several widths.

#include <string>
#include <vector>

#include "request/map_directions.h"
#include "tramline/model/plan.h"

namespace tramline::app {

/// What one map comes to. Areas as in Zhou §2.3.5: of the tracks alone, compared with the body.
struct MapCell {
  MapDirection asked;
  Machine machine;
  Tally tracks;
  double body_m2 = 0;
  double cost = 0;                      ///< of the whole plan
  std::vector<Direction> directions{};  ///< of the subfields that have tracks
  double seconds = 0;                   ///< of planning
  std::string refusal{};  ///< why there is no such map, as the planner says; empty: there is one
};

/// The cell of a plan.
MapCell map_cell(const MapDirection& asked, const Plan& plan, double seconds);

/// A cell for each direction at each width, by direction.
struct MapTable {
  Field field;
  std::vector<double> widths_m;
  std::size_t edges_left_out = 0;
  std::vector<MapCell> cells;
};

}  // namespace tramline::app
