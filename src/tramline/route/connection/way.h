#pragma once
// A way from where one work ends to where the next begins.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"
#include "tramline/model/route.h"

namespace tramline {

/// Driven with the work off, the straight lines on which the implement is lifted and lowered included.
struct Way {
  LegKind kind = LegKind::kTurn;  ///< kTurn or kTransit
  SteeredPath path{};
  bool backs_out = false;      ///< begins in reverse along what was worked
  bool backs_in = false;       ///< ends in reverse along what is to be worked
  bool supposed = false;       ///< backs out along a way before the work that is not known yet
  double time_s = 0;           ///< lengths by their speeds, and changes of gear
  double cost_s = 0;           ///< time, and what driving over crop counts more
  double missing_m = 0;        ///< how far the outline leaves the land; 0: it has room
  bool backs_on_land = false;  ///< where the way has no room, none is missing where it backs
  double lateral_error_m = 0;  ///< of a towed implement where the work begins

  bool has_room() const { return missing_m == 0; }
};

/// The time to drive a path with the work off, from work forward to work forward, s.
double idle_seconds(const SteeredPath& path, const Turning& turning);

/// What the machine has driven forward without a break when it ends a work, the last kilometre of it at most:
/// it can back along that. `before`: the same when it began the way to the work. Where the way has no room,
/// the work alone; where it changes gear on the way, from there on. O(stretches).
SteeredPath driven_forward(const SteeredPath& before, const Way& way, const SteeredPath& work);

/// The legs that a way comes to, in the order driven, one for each gear; without their times.
std::vector<RouteLeg> legs_of(const Way& way);

}  // namespace tramline
