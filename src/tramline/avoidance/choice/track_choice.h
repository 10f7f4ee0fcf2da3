#pragma once
// The cheapest way along one track, all its obstacles decided together.

#include <optional>

#include "tramline/avoidance/choice/track_options.h"
#include "tramline/model/objective.h"

namespace tramline {

/// A way prescribed at one gap of a track.
struct Forced {
  std::size_t gap = 1;
  Passing way = Passing::kCut;
};

struct TrackChoice {
  std::vector<TrackDetour> detours;  ///< along the track
  double cost = 0;  ///< of the track's pieces, all land that nothing else covers counted as gain: comparable
                    ///< between choices for one track
};

/// Cost of a track's pieces when it is driven with these detours (a subset of its options).
double track_cost(const BlockedTrack& blocked, const Track& track, double width_m,
                  const std::vector<TrackDetour>& detours, const Objective& objective, double min_length_m);

/// The cheapest set of detours by dynamic programming along the track: the pieces between two cuts are
/// independent of the rest, and so are the areas of detours that follow one another. Ties go to fewer cuts.
/// nullopt where the forced way is impossible. O(g²·(o + pieces)) for g gaps and o options at each.
std::optional<TrackChoice> cheapest_choice(const BlockedTrack& blocked, const Track& track, double width_m,
                                           const Objective& objective, double min_length_m,
                                           std::optional<Forced> forced = {});

}  // namespace tramline
