#pragma once
// Fields, machines and lines to back along.

#include <optional>
#include <random>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/machine.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline::testing {

Heading towards_deg(double clockwise_from_north);

/// 6 m wide, radius 6 m, 1.5 m/s forward and 1 m/s in reverse, 2 s to change the gear.
Machine six_metres();

Ring rectangle_of(double wide_m, double long_m);

/// Straight north to a place, or south from it.
SteeredPath north_to(Point at, double length_m);
SteeredPath south_from(Point at, double length_m);

/// A field that is often narrow, with four sides or five.
Ring random_field_of_sides(std::mt19937_64& random);

struct Line {
  SteeredPath driven;
  bool bent = false;
  bool turns_far = false;  ///< by more than 0.5 rad
};

/// A line to where the outline meets the edge of the land ahead, or short of it, straight or bent behind the
/// last metres; along the sides or aslant. One that turns far has room all along.
std::optional<Line> random_line(const Ring& field, const AllowedLand& land, const Machine& machine,
                                std::mt19937_64& random);

Machine random_machine_that_backs(std::mt19937_64& random);

}  // namespace tramline::testing
