#pragma once
// What guidance terminals are told of a field: its outlines, and lines to drive along.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/io/export/export_format.h"
#include "tramline/model/coverage.h"
#include "tramline/model/field.h"
#include "tramline/model/local_frame.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// A line to drive along, in driving direction. Of two points it is an AB line, of more a curve.
struct TerminalLine {
  std::string name;           ///< "AB 1", "Curve 2", "Track 12", "Headland 3"
  bool parallels = false;     ///< whether the terminal is to make parallels to it
  std::vector<Point> points;  ///< at least two, no two in succession alike
  std::size_t subfield = 0;   ///< of a track, like the next
  int track = 0;
  bool straight() const { return points.size() == 2; }
};

/// Missed land, with the number that maps and other files give it.
struct NumberedGap {
  int number = 0;
  Polygon shape;

  friend bool operator==(const NumberedGap&, const NumberedGap&) = default;
};

/// Frame: the field's local metres, which is geodetic.
struct TerminalField {
  std::string name;  ///< id of the field, UTF-8
  LocalFrame frame;
  double width_m = 0;  ///< from line to line
  double area_m2 = 0;
  Ring outer;
  std::vector<Obstacle> obstacles;
  Region headland;
  Region body;  ///< the land that tracks work; empty: there is no headland
  std::vector<TerminalLine> lines;
  std::vector<NumberedGap> gaps;  ///< of a coverage or a repair plan
  Region worked;                  ///< land of the field that was worked before
};

/// The lines of a plan. Of a subfield with straight tracks it is the line of its longest track, prolonged to
/// the ends of the subfield; of one with curved tracks the longest stretch of them without a detour.
/// Subfields without tracks have none. Curves stay within `tolerance_m` of the track. O(n) in pieces and
/// vertices.
std::vector<TerminalLine> lines_of(const Plan& plan, LineChoice choice, double tolerance_m);

/// Heading from true north in degrees, as the line sets out from A, in [0, 360).
double true_heading_deg(const TerminalLine& line, const LocalFrame& frame, Point a_lonlat);

struct LineCounts {
  std::size_t lines = 0, curves = 0;  ///< curves are among the lines
};
LineCounts counts_of(const std::vector<TerminalLine>& lines);

/// All of it; the headland's outline is thinned to `tolerance_m`, the field's and the obstacles' are kept.
/// Throws Error(kBadInput) naming `file` where the field is in plain metres, which have no place on the
/// globe.
TerminalField terminal_field(const Plan& plan, LineChoice choice, double tolerance_m,
                             const std::string& file);

/// Of an evaluated drive, for each connected part of the field: its outline, its holes as obstacles, and the
/// gaps in it. Throws Error(kBadInput) naming `file` where there is no field, or it is in plain metres.
std::vector<TerminalField> terminal_fields(const Coverage& coverage, double tolerance_m,
                                           const std::string& file);

}  // namespace tramline::io
