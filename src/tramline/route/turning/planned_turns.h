#pragma once
// The turns between the pieces of a plan.

#include <optional>
#include <vector>

#include "tramline/model/manoeuvre.h"
#include "tramline/model/plan.h"
#include "tramline/model/track.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// The hop from one piece to the next: the end of the one and the start of the other, along their tracks.
struct Hop {
  Pose end;
  Pose start;
};
Hop hop_between(const TrackPiece& from, const TrackPiece& to);

/// Straight ways besides those on which the implement is lifted and lowered, m.
struct StraightWays {
  double before_m = 0;  ///< before the machine turns
  double after_m = 0;   ///< in line with the next track
};

/// A manoeuvre over a hop, and whether it leads back over the tracks, behind the line through both their
/// ends.
struct HopWay {
  Manoeuvre manoeuvre;
  bool over_tracks = false;
};

/// All manoeuvres of the machine over a hop with the straight ways before and after them: those that stay
/// before the ends of the tracks, quickest first, then those that lead back over them.
std::vector<HopWay> manoeuvres_over(const Hop& hop, const Machine& machine, const StraightWays& more);

/// The quickest manoeuvre with room that stays before the ends of the tracks; where there is none, one that
/// drives straight on before it turns, or comes into line farther off, with the least such ways: past a pylon
/// beside the end, or out of a corner. nullopt where there is none, and where the ends are far apart unless
/// it is direct.
std::optional<Manoeuvre> turn_before_ends(const Hop& hop, const AllowedLand& land, const Machine& machine,
                                          const StraightWays& least);

/// Whether a hop is more than a turn: several times as far as a turn is wide.
bool far_apart(const Hop& hop, const Machine& machine);

/// The turn from each piece to the next one in driving order, except across passable obstacles: the quickest
/// manoeuvre of the machine that stays on the land, from where the work ends to where it begins, the way on
/// which the implement is lifted and lowered included. A towed implement gets as much run-in as brings its
/// lateral error at the first worked metre under `towing_error_m` where there is room for it. O(n) for n
/// pieces, times the manoeuvres of a machine and the room test.
std::vector<PlannedTurn> planned_turns(const AllowedLand& land, const Machine& machine,
                                       const std::vector<TrackPiece>& pieces, double towing_error_m);

/// Fills in the turns of a plan with pieces, and marks as stops the ends without a way off (mark_stops()).
/// Returns the number of stops.
int plan_turns(const AllowedLand& land, Plan& plan);

}  // namespace tramline
