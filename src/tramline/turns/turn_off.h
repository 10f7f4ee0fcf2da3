#pragma once
// Whether a machine gets away from the end of a track at all.

#include <array>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// The shortest ways off a track: from the pose in which the work has ended, straight on until the implement
/// is lifted, then a quarter turn to the left or to the right, as tight as the machine steers. Every
/// manoeuvre that leads back without reversing first sweeps at least as far ahead as one of the two.
std::array<SteeredPath, 2> ways_off(const Pose& axle_at_end, const Machine& machine);

/// The same from the end of a track: the implement has reached it.
std::array<SteeredPath, 2> ways_off_end(Point end, Heading heading, const Machine& machine);

/// Whether either way off is on the land. Where neither is, the end is a stop: the machine has to back out.
bool has_way_off(const AllowedLand& land, Point end, Heading heading, const Machine& machine);

}  // namespace tramline
