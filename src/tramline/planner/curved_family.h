#pragma once
// A family of tracks parallel to a curve over the whole ground (S2.11-S2.13).

#include <optional>
#include <vector>

#include "tramline/avoidance/choose_detours.h"
#include "tramline/planner/candidate.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// A family of curved tracks over the whole ground.
struct CurvedCandidate {
  std::vector<Point> line;  ///< what the reference was made of
  Path reference;      ///< smoothed for the machine, extended across the ground; with S2's tracks as it is
  bool round = false;  ///< goes all the way round the ground
  LaidTracks tracks;
  Tally tally;
  double cost = 0;
  Region worked{};                            ///< with S2's tracks: the union of their swaths
  std::vector<PlacedEncounter> encounters{};  ///< where detours have been looked for
};

/// What tracks run parallel to.
struct Reference {
  std::vector<Point> line;  ///< what it was made of
  Path path;                ///< no tighter than the machine turns, not yet extended
  double deviation_m = 0;   ///< from the line that was given
  bool round = false;       ///< all the way round the ground, and back to where it began
};

/// The line smoothed to what the machine drives and to `tolerance_m`. Throws kBadInput for a line that
/// smoothed() refuses, and where a line all the way round shrinks to a point.
Reference reference_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m);

/// Tracks parallel to the reference, which is moved `right_m` to the right and extended along its end
/// tangents across the ground: offset by (k + ½)·w to either side. Cut at obstacles; passable ones are
/// crossed. Without a track where the reference cannot be moved so far.
CurvedCandidate curved_along(const SearchTask& task, const Reference& reference, double right_m = 0);

/// The same on ground that is ready. Where there is nothing for detours to go round it is given up, without a
/// track, as soon as it is certain to cost more than `no_more_than`.
CurvedCandidate curved_along(const SearchTask& task, const CurvedGround& ground, const Reference& reference,
                             double right_m, double no_more_than);

/// The same family with the ways past obstacles that the settings ask for, and what was decided where.
/// Never costlier.
CurvedCandidate with_detours(const SearchTask& task, CurvedCandidate candidate);

/// Sets how many parts of the ground have tracks, and the cost that follows from the tally.
void count_subfields(const SearchTask& task, CurvedCandidate& candidate);

/// Whether curved tracks meet anything that they may go round or cross.
bool asks_for_detours(const SearchTask& task);

/// What curved pieces have to keep to.
CurvedGround curved_ground(const SearchTask& task);

}  // namespace tramline
