#pragma once
// The pieces driven in the strips of one subfield.

#include <vector>

#include "tramline/geometry/cross_section.h"
#include "tramline/model/machine.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {

/// A piece in its strip: coordinates along the grid's direction, from < to.
struct StripPiece {
  int strip = 0;
  double from = 0;
  double to = 0;
  bool stop_at_from = false;
  bool stop_at_to = false;
  bool after_crossing = false;  ///< a passable obstacle, and nothing else, lies before `from`
  double inside_m2 = 0;         ///< area of the swath inside its own subfield
};

/// The ground of a field in the turned plane of one grid.
struct TurnedGround {
  Region hard;  ///< obstacles and given-up land
  Region passable;
  Region field;  ///< the field's outer ring where it is hard, else empty
};

/// One subfield with its tracks.
struct SubfieldTracks {
  StripGrid grid;
  std::vector<StripPiece> pieces;   ///< by strip, then along
  std::vector<StripPiece> dropped;  ///< shorter than the machine's least length (S1.14)
};

/// In every strip the stretches the end rule allows, less the along-track extent of everything hard
/// (S1.40), interrupted over passable obstacles; what is shorter than the least length is dropped
/// unless it lies between two crossings. `turned` is the subfield in the grid's plane.
/// O(n + K log K) for n edges and K incidences of edges and strips.
SubfieldTracks strip_pieces(const StripGrid& grid, const Polygon& turned, const TurnedGround& ground,
                            const EndCriterion& criterion, double min_length_m);

}  // namespace tramline
