#pragma once
// Tracks side by side, and the stretches in which each may be driven.

#include <vector>

#include "tramline/geometry/strip/strip_grid.h"
#include "tramline/tracks/track_profile.h"

namespace tramline {

/// One track of a family. Positions along it are coordinates along the grid's direction where it is straight,
/// and metres from the beginning of its path where it is curved.
struct Track {
  int index = 0;          ///< the swath lies between lines `index` and `index` + 1 of the family's grid
  int branch = 0;         ///< index among the paths of that index: a curve's offset may be in several parts
  bool closed = false;    ///< ends where it begins: positions continue beyond its length
  Path path{};            ///< of a curved track, in the field's frame; empty: the centre line of a strip
  double length_m = 0;    ///< of the path
  TrackProfile subfield;  ///< of the land that its pieces have to cover
  TrackProfile hard;      ///< of the land that no swath enters
  Intervals hard_stretches;      ///< where anything hard reaches into the swath
  Intervals passable_stretches;  ///< where a passable obstacle reaches into the swath
  Intervals stretches;  ///< where the end rule allows driving, less hard land and land beyond a hard boundary
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

/// The path of a curved track between two positions; beyond its length a closed one continues from its
/// beginning.
Path path_along(const Track& track, double from, double to);

/// Whether a piece that ends at `end`, running towards it in the sense (+1: along, −1: against), ends in a
/// stop: in the first millimetre beyond, hard land takes more than half the width tolerance on average.
bool stops_at(const Track& track, double end, int sense);

}  // namespace tramline
