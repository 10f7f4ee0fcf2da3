#pragma once

#include <algorithm>

namespace tramline {

/// Areas, lengths and counts of a set of tracks. Areas in m², lengths in m.
/// Identity: worked_m2 = body − uncovered_m2 + overlap_m2.
struct Tally {
  double worked_m2 = 0;     ///< Σ w·L
  double overlap_m2 = 0;    ///< worked minus usefully worked area
  double uncovered_m2 = 0;  ///< body minus what the swaths cover of it
  double track_length_m = 0;
  int pieces = 0;
  int crossings = 0;  ///< of passable obstacles, within one track
  int turns = 0;      ///< max(0, pieces − 1 − crossings)
  int stops = 0;      ///< piece ends against an obstacle without headland
  int subfields = 0;  ///< those with a piece; a repair has one
};

/// The number of subfields that cost something: all but the first.
constexpr int further_subfields(const Tally& tally) { return std::max(0, tally.subfields - 1); }

}  // namespace tramline
