#pragma once
// What a plan costs at the least, whatever its route.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {

/// A lower bound of whole_cost() in euros for a plan whose route is not known yet: all pieces and passes at
/// working speed, overlap and missed land, and for every two tracks that no pass and no change of subfield
/// can come between half a circle, since parallel tracks are left and entered in opposite directions. Every
/// end of a track or of an open pass without a way off has to be backed out of, or into, unless the route
/// begins or ends there or the machine turns with reversing; all else counts nothing. O(pieces + passes), and
/// the room at every end.
double route_floor(const Plan& plan, const AllowedLand& turning_land);

/// The same without backing, of a plan that has these passes instead of its own: less by price_of_stops().
/// O(pieces + passes).
double floor_without_stops(const Plan& plan, const std::vector<HeadlandPass>& passes);

/// What backing out of ends without a way off costs a plan at the least, EUR. O(pieces + passes) rooms.
double price_of_stops(const Plan& plan, const AllowedLand& turning_land);

}  // namespace tramline
