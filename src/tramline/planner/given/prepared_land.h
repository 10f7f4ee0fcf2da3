#pragma once
// What the user gave of the land, made out on the land to plan.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// A connected part of the plannable land between the borders that the user drew.
struct LandPart {
  Polygon shape;
  std::string
      given_by{};  ///< where it was drawn: it is a subfield of its own; empty: the planner may divide it
  std::optional<Direction> direction{};  ///< of its tracks, where the user gave one
  std::vector<Point> guide{};            ///< the line that its tracks follow, where the user gave one
};

/// Local metres.
struct PreparedLand {
  /// The land of the field that the plan is not for, as in Plan::worked.
  Region worked;
  std::size_t left_out = 0;  ///< as in Plan
  /// Of all plannable land, where the user divides it; else empty.
  std::vector<LandPart> parts;
  std::vector<std::string> remarks;  ///< what became of the shapes that the user drew; sentences
};

}  // namespace tramline
