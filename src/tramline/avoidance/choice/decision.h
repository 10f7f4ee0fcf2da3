#pragma once
// The decision on one blocked track, straight or curved, and how choices are distinguished.

#include <optional>
#include <vector>

#include "tramline/avoidance/choice/track_choice.h"
#include "tramline/model/detour.h"

namespace tramline {

/// A track that obstacles block, its options, and the detours chosen so far.
struct Decision {
  BlockedTrack track;
  std::vector<TrackDetour> chosen;
};

/// Whether both sets of detours drive the same paths.
bool same_detours(const std::vector<TrackDetour>& a, const std::vector<TrackDetour>& b);
/// Whether two ways past the same gaps are equal up to rounding.
bool same_drive(const WayRound& a, const WayRound& b);
/// Whether the way is, up to rounding, already an option of the track.
bool has_option(const BlockedTrack& track, const WayRound& way);

/// A way past one gap, priced as the cost of the whole track above that with a cut there; where no choice
/// contains it, with the reason for which it was refused.
WayPast way_past(const BlockedTrack& track, const Forced& forced, const std::optional<TrackChoice>& choice,
                 double cost_of_cut, WaysPast ways);

/// A row of gaps, first to last, to be passed by one detour as an alternative to single ones.
struct GapRow {
  std::size_t first = 1;
  std::size_t last = 1;
};
/// The rows of gaps to try with one detour: detours on one side that would run into each other cannot both be
/// driven, but one round two of them, three, or the whole row can. `alone` are the possible ways past single
/// gaps on that side, ascending.
std::vector<GapRow> rows_to_join(const std::vector<WayRound>& alone);

}  // namespace tramline
