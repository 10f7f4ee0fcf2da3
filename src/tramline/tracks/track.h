#pragma once
// Tracks that lie side by side, and where each may be driven.

#include <vector>

#include "tramline/geometry/strip/strip_grid.h"
#include "tramline/tracks/track_profile.h"

namespace tramline {

/// One track of a family. Positions along it are coordinates along the grid's direction where it is straight,
/// and metres from the beginning of its path where it is curved.
struct Track {
  int index = 0;          ///< the swath lies between lines `index` and `index` + 1 of the family's grid
  int branch = 0;         ///< which of the paths of that index: a curve's offset may fall into several
  bool closed = false;    ///< ends where it begins: positions go on beyond its length
  Path path{};            ///< of a curved track, in the field's frame; empty: the centre line of a strip
  double length_m = 0;    ///< of the path
  TrackProfile subfield;  ///< of the land that its pieces are there to cover
  TrackProfile hard;      ///< of what no swath enters
  Intervals by_hard;      ///< where anything hard reaches into the swath
  Intervals by_passable;  ///< where a passable obstacle does
  Intervals stretches;    ///< what the end rule allows, less what is hard or beyond a hard boundary
};

inline bool is_straight(const Track& track) { return track.path.empty(); }

/// The tracks of one grid of strips, or those parallel to a curve.
struct TrackFamily {
  /// Line k lies k·w right of line 0: of straight tracks in the grid's turned plane; of curved ones line 0 is
  /// the reference, and the frame is the field's own.
  StripGrid grid;
  std::vector<Track> tracks;  ///< by index, then branch
};

/// Area of the subfield within the track's swath between two positions, m². On a closed track they may lie
/// beyond its length.
double inside_between(const Track& track, double from, double to);

/// A curved track between two positions; from beyond its length on, a closed one goes on from its beginning.
Path path_along(const Track& track, double from, double to);

/// Whether a piece that ends at `end` and runs towards it in the sense (+1: along, −1: against) ends in a
/// stop: the first millimetre beyond meets something hard, on average over more than half the width
/// tolerance.
bool stops_at(const Track& track, double end, int sense);

}  // namespace tramline
