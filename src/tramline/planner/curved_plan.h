#pragma once
// Plans whose tracks run parallel to a curve (S2.11-S2.13).

#include <optional>

#include "tramline/planner/candidate.h"
#include "tramline/tracks/curved_pieces.h"

namespace tramline {

/// A family of curved tracks over the whole ground.
struct CurvedCandidate {
  Path reference;  ///< smoothed for the machine, extended across the ground
  CurvedTracks tracks;
  Tally tally;
  double cost = 0;
};

/// What tracks run parallel to.
struct Reference {
  Path path;               ///< no tighter than the machine turns, not yet extended
  double deviation_m = 0;  ///< from the line that was given
  bool round = false;      ///< all the way round the ground, and back to where it began
};

/// The line smoothed to what the machine drives and to `tolerance_m`. Throws kBadInput for a line that
/// smoothed() refuses.
Reference reference_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m);

/// Tracks parallel to the reference, which is moved `right_m` to the right and extended along its end
/// tangents across the ground: offset by (k + ½)·w to either side. Cut at obstacles, and at passable ones
/// too. Without a track where the reference cannot be moved so far.
CurvedCandidate curved_along(const SearchTask& task, const Reference& reference, double right_m = 0);

/// The same on ground that is ready. Given up, without a track, as soon as it is certain to cost more than
/// `no_more_than`.
CurvedCandidate curved_along(const SearchTask& task, const CurvedGround& ground, const Reference& reference,
                             double right_m, double no_more_than);

/// What curved pieces have to keep to.
CurvedGround curved_ground(const SearchTask& task);

/// The cheapest family along a chain of boundary edges between two corners of the ground, at several levels
/// of smoothing, the best of them moved sideways as well; nullopt where no chain is curved, or none has a
/// track. Deterministic for any number of threads. O(chains) families.
std::optional<CurvedCandidate> best_curved(const SearchTask& task, int threads);

/// As a plan: tracks numbered from the reference, driven up and down one after another. Throws kBadInput
/// where it has no piece.
Plan finished_plan(const SearchTask& task, const CurvedCandidate& candidate);

}  // namespace tramline
