#pragma once

#include "tramline/geometry/point.h"
#include "tramline/geometry/region.h"

namespace tramline {

/// One uninterrupted stretch driven with the work on: a straight centre line from start to end, in
/// driving direction, and the flat-ended swath of the working width along it.
struct TrackPiece {
  Point start;
  Point end;
  int subfield = 0;  ///< index into Plan::subfields
  int track = 0;     ///< number of the strip within the subfield, from 0 at its origin edge
  bool stop_at_start = false;
  bool stop_at_end = false;
  /// The same track goes on beyond a passable obstacle that lies between the previous piece (in
  /// driving order) and this one: neither a turn nor a stop.
  bool after_crossing = false;
};

inline double length(const TrackPiece& piece) { return distance(piece.start, piece.end); }

/// The ground a piece works: a rectangle, counter-clockwise. Precondition: start != end.
Ring swath(const TrackPiece& piece, double width_m);

}  // namespace tramline
