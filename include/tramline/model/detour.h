#pragma once
// What a track does about the obstacles it meets.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// How tracks get past obstacles.
enum class Avoidance {
  kCheapest,  ///< whichever of left, right and cut costs least
  kPaper,     ///< S1: round obstacles narrower than a threshold, by S1's constructions
  kCut,       ///< every track ends before an obstacle and begins again behind it
};

enum class Passing { kLeft, kRight, kCut };

/// Part of a track that leaves the track's line to go round obstacles, and comes back to it.
struct Detour {
  Path path;                      ///< begins and ends on the track's line, tangentially, in driving direction
  Passing side = Passing::kLeft;  ///< of the obstacles, seen in driving direction; never kCut
  /// Indices into Field::obstacles, ascending; empty: land given up only.
  std::vector<std::size_t> obstacles;
};

/// One way of getting past an obstacle.
struct WayPast {
  bool possible = false;
  double cost = 0;      ///< of the plan above that of a cut here, everything else as in the plan
  std::string why_not;  ///< in a few words, where it is not possible
};

/// A place where a track meets obstacles, and what was decided there.
struct Encounter {
  std::size_t subfield = 0;            ///< index into Plan::subfields
  int track = 0;                       ///< as in TrackPiece
  Point at;                            ///< on the track's line, in the middle of the stretch it cannot drive
  std::vector<std::size_t> obstacles;  ///< as in Detour
  Passing chosen = Passing::kCut;
  WayPast left;  ///< seen in driving direction; in that of the subfield where the track is not driven
  WayPast right;
};

}  // namespace tramline
