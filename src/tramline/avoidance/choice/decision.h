#pragma once
// What is decided about one blocked track, straight or curved, and what it is told apart by.

#include <optional>
#include <vector>

#include "tramline/avoidance/choice/track_choice.h"
#include "tramline/model/detour.h"

namespace tramline {

/// A track that obstacles block, its options, and what is chosen so far.
struct Decision {
  BlockedTrack track;
  std::vector<TrackDetour> chosen;
};

/// Do both sets of detours drive the same?
bool same_detours(const std::vector<TrackDetour>& a, const std::vector<TrackDetour>& b);
/// Are two ways past the same gaps one, up to rounding?
bool same_drive(const WayRound& a, const WayRound& b);
/// Is the way, up to rounding, an option of the track already?
bool has_option(const BlockedTrack& track, const WayRound& way);

/// A way past one gap at the price of the whole track, against that of a cut there; where no choice has it,
/// with the reason it was refused for.
WayPast way_past(const BlockedTrack& track, const Forced& forced, const std::optional<TrackChoice>& choice,
                 double cost_of_cut, WaysPast ways);

/// The gaps to pass in one go, from the first to the last, besides one by one.
struct GapRow {
  std::size_t first = 1;
  std::size_t last = 1;
};
/// Detours on one side that would run into each other cannot both be driven, but one round all of them can:
/// two of them, three, and the whole row. `alone` are the possible ways past single gaps on that side,
/// ascending.
std::vector<GapRow> rows_to_join(const std::vector<WayRound>& alone);

}  // namespace tramline
