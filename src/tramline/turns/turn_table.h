#pragma once
// What a machine needs to get from a track to its neighbours: how deep a headland, how long, how many passes.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/model/manoeuvre.h"

namespace tramline {

/// The border is a straight line at which all tracks end. The machine comes along one track and goes back
/// along another on its right.
struct TurnTableSettings {
  std::vector<double> spacings_m;  ///< of the tracks, > 0; empty: 1 to 8 working widths
  /// From the track to the border on the right, clockwise from the way ahead, between 0 and 180°: 90° is
  /// square; with less the next track reaches farther, with more it ends earlier.
  Angle border = Angle::degrees(90);
};

/// How a machine may turn between two tracks. Lengths in metres.
struct TurnRow {
  double spacing_m = 0;
  Manoeuvre manoeuvre;      ///< the first track ends at the origin and leads along +y, the next is at +x
  double axle_depth_m = 0;  ///< how far the middle of the axle gets beyond the border, square to it
  double depth_m = 0;       ///< how far anything of machine and implement gets beyond it, at least 0
  /// How far the axle gets back over the tracks, square to the border, beyond where it begins and ends.
  double back_m = 0;
  double length_m = 0;  ///< of the manoeuvre, without lift_m and lower_m
  double time_s = 0;    ///< of the same
  int passes = 0;       ///< headland passes of the working width that are together depth_m wide
  int gear_changes = 0;
  /// Of a towed implement: driven straight on after the turn until its axle stays within kTowedInLine_m of
  /// the track; infinite where it never does.
  std::optional<double> run_in_m;
};

inline constexpr double kTowedInLine_m = 0.1;

/// The manoeuvres to each spacing, in the order of the spacings; of one spacing the quickest first. None for
/// a spacing that the machine has no way to. A machine that tows does not reverse. Preconditions: radius_m,
/// width_m and all speeds > 0; spacings > 0; the border between 0 and 180°. O(1) for each spacing, but for
/// clothoids and drawbars, which are bounded to kSweptReach_m.
std::vector<TurnRow> turn_table(const Machine& machine, const TurnTableSettings& settings);

/// The poses between which the machine turns in a row of this spacing.
Pose turn_begins(const Machine& machine);
Pose turn_ends(const Machine& machine, double spacing_m, Angle border);

/// Passes of this width that are together so deep, with kSameDepth of a pass for rounding. Precondition:
/// width_m > 0.
int passes_for(double depth_m, double width_m);

/// A turn that gets back over the tracks by more than this, m, drives over land that is worked or to be
/// worked: about the width of a wheel.
inline constexpr double kStaysOffTracks_m = 0.5;

/// The rows of one spacing; empty where there are none.
std::vector<TurnRow> rows_of(const std::vector<TurnRow>& rows, double spacing_m);

/// Of rows of one spacing that with the least time, and that with the least depth, of equal ones the first:
/// among those that stay off the tracks, or among all where none does. Precondition: not empty.
std::size_t quickest(const std::vector<TurnRow>& rows);
std::size_t shallowest(const std::vector<TurnRow>& rows);

/// The quickest row of each spacing.
std::vector<TurnRow> quickest_of_each(const std::vector<TurnRow>& rows);

}  // namespace tramline
