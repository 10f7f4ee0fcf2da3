#pragma once
// The legend of a plan as plain text.

#include <string>
#include <vector>

#include "tramline/model/plan.h"

namespace tramline::render {

/// The symbol in front of a row.
enum class Symbol {
  kNone,
  kField,
  kSubfield,
  kObstacle,
  kPassable,
  kGivenUp,
  kTrack,
  kDetour,
  kTurn,
  kTurnInReverse,
  kNoRoom,
  kTransit,
  kBackOut,
  kRouteStart,
  kRouteEnd,
  kHeadland,
  kHeadlandPass,
  kReference,
  kTightestArc,
  kKeepOff,
  kSwathEdge,
  kDropped,
  kStop,
  kOverlap,
  kUncovered,
  kNotRecorded,
  kCovered,
  kCoveredOutside,
  kWorkedPath,
  kIdlePath,
  kGap,
};

struct LegendRow {
  Symbol symbol = Symbol::kNone;
  int index = 0;      ///< which subfield or gap, from 0
  std::string text;   ///< at the left
  std::string value;  ///< at the right, with its unit
};

struct LegendBlock {
  std::string heading;
  std::vector<LegendRow> rows;
};

/// Symbols that occur in the plan, the numbers, and the subfields with their directions.
std::vector<LegendBlock> legend_of(const Plan& plan);

/// "12.34 ha", or "840 m²" below a tenth of a hectare.
std::string area_text(double area_m2);
/// "3.21 km", or "840 m" below a kilometre.
std::string length_text(double length_m);

}  // namespace tramline::render
