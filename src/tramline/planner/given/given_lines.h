#pragma once
// Lines that somebody else drew or planned.

#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

struct GivenLine {
  Path path;         ///< as drawn; may have segments without length
  int subfield = 0;  ///< of lines exported by us, that of the plan; lines of one number are one subfield
  std::string name;  ///< for people: "lines.geojson feature 3"
};

/// Frame: the field's local metres.
struct GivenLines {
  std::vector<GivenLine> tracks;  ///< in driving order
  std::vector<GivenLine> passes;  ///< round the field or obstacles; no turns are counted between them
};

}  // namespace tramline
