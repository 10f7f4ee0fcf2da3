#pragma once
// Manoeuvres: how a machine gets from the end of one track to the start of the next.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"

namespace tramline {

/// kU: two equal turns to one side, quarter circles between parallel tracks, and a line between them. kOmega:
/// a turn out, one of more than half a circle, a turn back. kUnequalArcs: turns of different angle, or a line
/// on and then a U or omega, as at oblique borders (P). kFishtail: turn, reverse, turn. kDubins, kReedsShepp:
/// any other shortest path forward, or with reversing. kBackOut: back along the track.
enum class ManoeuvreKind { kU, kOmega, kUnequalArcs, kFishtail, kDubins, kReedsShepp, kBackOut };

const char* name(ManoeuvreKind kind);  ///< u, omega, unequal_arcs, fishtail, dubins, reeds_shepp, back_out

/// The way of the rear axle's middle, from the pose in which the work ends to the pose in which it begins.
struct Manoeuvre {
  ManoeuvreKind kind = ManoeuvreKind::kDubins;
  std::string word;  ///< a letter for each turn or line: L, R or S, in lower case where driven in reverse;
                     ///< a turn that begins and ends with clothoids is one letter and up to three stretches
  SteeredPath path;
};

/// Changes of gear, with those before and after it: the machine comes forward from the track and goes on
/// forward.
int gear_changes(const Manoeuvre& manoeuvre);

/// The time that the manoeuvre takes, s: lengths by the speeds of turning and reversing, and the changes of
/// gear.
double seconds(const Manoeuvre& manoeuvre, const Machine& machine);

/// What became of a turn. kNoRoom: no manoeuvre of the machine stays on the land. kApart: none does, and the
/// tracks are far apart: the way between them is more than a turn.
enum class TurnState { kFits, kNoRoom, kApart };

const char* name(TurnState state);  ///< fits, no_room, apart
std::optional<TurnState> turn_state_named(std::string_view word);
std::optional<ManoeuvreKind> manoeuvre_kind_named(std::string_view word);

/// The turn from the end of one piece to the start of the next one in driving order.
struct PlannedTurn {
  std::size_t after = 0;  ///< index of the piece that it follows
  TurnState state = TurnState::kFits;
  Manoeuvre manoeuvre{};  ///< the quickest that fits; else the one that lacks least room, for display
  double time_s = 0;
  double missing_m = 0;        ///< how far it leaves the land, where it does not fit
  double lateral_error_m = 0;  ///< of a towed implement where the work begins
};

}  // namespace tramline
