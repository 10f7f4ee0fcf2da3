#pragma once
// Plans whose tracks run parallel to a curve (S2.11-S2.13).

#include <optional>

#include "tramline/planner/candidate.h"
#include "tramline/tracks/curved_pieces.h"

namespace tramline {

/// A family of curved tracks over the whole ground.
struct CurvedCandidate {
  Path reference;          ///< smoothed for the machine, extended across the ground
  double deviation_m = 0;  ///< of the smoothed line from the one that was given
  CurvedTracks tracks;
  Tally tally;
  double cost = 0;
};

/// Tracks along a line: smoothed to what the machine drives and to `tolerance_m`, extended along its end
/// tangents across the ground, offset by (k + ½)·w to either side. Cut at obstacles, and at passable ones
/// too. Throws kBadInput for a line that smoothed() refuses.
CurvedCandidate curved_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m);

/// The cheapest family along a chain of boundary edges between two corners of the ground, at several levels
/// of smoothing; nullopt where no chain is curved, or none has a track. Deterministic for any number of
/// threads. O(chains) families.
std::optional<CurvedCandidate> best_curved(const SearchTask& task, int threads);

/// As a plan: tracks numbered from the reference, driven up and down one after another. Throws kBadInput
/// where it has no piece.
Plan finished_plan(const SearchTask& task, const CurvedCandidate& candidate);

}  // namespace tramline
