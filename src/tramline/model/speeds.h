#pragma once
// How fast a machine drives what.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"
#include "tramline/model/route.h"

namespace tramline {

/// The speed with the work off, m/s: of turning, or in reverse.
double speed_with_work_off(Gear gear, const Turning& turning);

/// The speed at which a leg of a route is driven, m/s: at work, or with the work off in its gear.
double speed_of(const RouteLeg& leg, const Turning& turning);

}  // namespace tramline
