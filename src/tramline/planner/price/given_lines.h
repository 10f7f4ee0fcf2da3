#pragma once
// Lines that somebody else drew or planned.

#include <cstdint>
#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// What is known of the way from the line before: lines alone say nothing, plans and exports of ours do.
enum class WayHere : std::uint8_t { kUnknown, kTurn };

struct GivenLine {
  Path path;         ///< as drawn; may have segments without length
  int subfield = 0;  ///< of lines exported by us, that of the plan; lines of one number are one subfield
  std::string name;  ///< for people: "lines.geojson feature 3"
  WayHere way_here = WayHere::kUnknown;  ///< kTurn: it goes on after no crossing, whatever lies between
};

/// Frame: the field's local metres.
struct GivenLines {
  std::vector<GivenLine> tracks;     ///< in driving order
  std::vector<GivenLine> passes;     ///< round the field or obstacles; no turns are counted between them
  std::vector<std::string> notes{};  ///< what the user is to know of how they were read
};

}  // namespace tramline
