#pragma once
// Where the axle is when the work ends and begins.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"

namespace tramline {

/// The distance from the axle back to where the implement works, m: on a straight line also of a towed one.
double reach_back_m(const Turning& turning);

/// The pose in which a machine may begin to turn that has worked up to `end`, driving along the heading: the
/// implement has reached the end, and the machine has driven on straight for lift_m.
Pose pose_after_work(Point end, Heading heading, const Turning& turning);

/// The pose in which a turn has to end for the work to begin at `start`, along the heading: lower_m before
/// the implement gets there. Where that is farther back than the implement is behind the axle, the machine
/// drives straight up to the start.
Pose pose_before_work(Point start, Heading heading, const Turning& turning);

}  // namespace tramline
