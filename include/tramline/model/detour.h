#pragma once
// How tracks get past obstacles.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// The rule by which tracks get past obstacles.
enum class Avoidance {
  kCheapest,  ///< whichever of left, right and cut costs least
  kPaper,     ///< Versleijen: round obstacles narrower than a threshold, by Versleijen's constructions
  kCut,       ///< every track ends before an obstacle and begins again behind it
};

enum class Passing { kLeft, kRight, kCut };

/// The part of a track that leaves the track's line to go round obstacles and comes back to it.
struct Detour {
  Path path;  ///< begins and ends on the track's line, tangentially, in driving direction
  /// On which the obstacles are passed, seen in driving direction; never kCut.
  Passing side = Passing::kLeft;
  /// Indices into Field::obstacles, ascending; empty: it goes round given-up land only.
  std::vector<std::size_t> obstacles;
};

/// One way of getting past an obstacle.
struct WayPast {
  bool possible = false;
  double cost = 0;      ///< extra cost of the plan compared with a cut here, all else being equal
  std::string why_not;  ///< the reason in a few words, where it is not possible
};

/// A stretch of a track blocked by obstacles, and the way past them that was chosen.
struct Encounter {
  std::size_t subfield = 0;            ///< index into Plan::subfields
  int track = 0;                       ///< as in TrackPiece
  Point at;                            ///< on the track's line, in the middle of the stretch it cannot drive
  std::vector<std::size_t> obstacles;  ///< as in Detour
  Passing chosen = Passing::kCut;
  WayPast left;  ///< seen in driving direction, or in the subfield's where the track is not driven
  WayPast right;
};

}  // namespace tramline
