#pragma once
// The ways past the obstacles of one track, and the changes each would make.

#include <cstdint>
#include <vector>

#include "tramline/avoidance/detour/way_round.h"
#include "tramline/cost/worked/worked_ground.h"

namespace tramline {

/// The construction of a way: ours or the paper's.
enum class Construction : std::uint8_t { kOwn, kPaper };

/// A detour that may be driven, and its value while everything off this track stays as it is.
struct TrackOption {
  WayRound way;
  Construction by = Construction::kOwn;
  std::size_t found = 0;           ///< number of options found before it
  std::vector<Box> reaches;        ///< of the detour's parts
  Box reach;                       ///< of the detour and the part of the track it replaces
  Interval replaced;               ///< part of the track that the detour replaces, gaps included
  double useful_m2 = 0;            ///< body that its swath alone covers
  double replaced_m2 = 0;          ///< body that the swath along the track it replaces alone covers
  double profile_m2 = 0;           ///< the same by the track's own profile
  bool far_too_expensive = false;  ///< with all other tracks cut: not worth an option of our own
  bool has_twin = false;           ///< the other construction drives the same path
  bool stale = true;               ///< something nearby has changed since it was valued
  /// Additional body covered when the detour replaces the straight parts.
  double gain_m2() const { return useful_m2 - replaced_m2; }
};

/// A way past one gap that cannot be driven.
struct RefusedWay {
  Construction by = Construction::kOwn;
  std::size_t gap = 1;
  Passing side = Passing::kLeft;
  Refusal why = Refusal::kNone;
};

/// A track with gaps made by hard land.
struct BlockedTrack {
  std::size_t family = 0;
  std::size_t place = 0;             ///< index in TrackFamily::tracks
  std::vector<std::size_t> gaps;     ///< those made by hazards: gap i lies between stretches i − 1 and i
  std::vector<TrackOption> options;  ///< possible ones that may be chosen now, by first gap
  std::vector<TrackOption> not_allowed;  ///< possible ones that may not be chosen now
  std::vector<RefusedWay> refused;
  /// By stretch: the area that a short stretch, which may not be worth driving, covers alone, less that of
  /// its profile. 0 for long ones.
  std::vector<double> correction_m2;
  bool stale = true;                  ///< whether any of the above is out of date
  bool only_one_driven = false;       ///< no other track has a piece: the first one adds no turn to the plan
  bool only_one_of_subfield = false;  ///< others have, but none of its family: the first adds a subfield
};

/// The gaps of a track made by hard land.
std::vector<std::size_t> hard_gaps(const Track& track);

/// Values the stale options (and short stretches) of a track against the land worked by the others. `body`
/// holds the body's rings in the plane of the family.
void value_options(BlockedTrack& track, const TrackFamily& family, const std::vector<Ring>& body,
                   const WorkedGround& ground, double min_length_m);

/// An option that has not been valued. `way` with its obstacles filled in.
TrackOption option_of(WayRound way, const StripGrid& grid, const Track& track);

/// Which ways past obstacles a track may choose from.
enum class WaysPast : std::uint8_t { kOwn, kPaper, kBoth };

/// Sorts the possible ways into allowed options and others. Of twins that both may be driven ours is the
/// option, even if it is far too expensive: the paper's plan is a reference to compare with. O(o log o) for o
/// ways.
void allow(BlockedTrack& track, WaysPast ways);

/// Marks as stale the options that depend on the land within a box of the family's plane.
void mark_stale(BlockedTrack& track, const TrackFamily& family, const Box& changed);
void mark_all_stale(BlockedTrack& track);

}  // namespace tramline
