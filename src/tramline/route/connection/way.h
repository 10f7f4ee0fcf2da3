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
  double time_s = 0;           ///< lengths by their speeds, and changes of gear
  double cost_s = 0;           ///< time, and what driving over crop counts more
  double missing_m = 0;        ///< how far the outline leaves the land; 0: it has room
  double lateral_error_m = 0;  ///< of a towed implement where the work begins

  bool has_room() const { return missing_m == 0; }
};

/// The time to drive a path with the work off, from work forward to work forward, s.
double idle_seconds(const SteeredPath& path, const Turning& turning);

/// The legs that a way comes to, in the order driven, one for each gear; without their times.
std::vector<RouteLeg> legs_of(const Way& way);

}  // namespace tramline
