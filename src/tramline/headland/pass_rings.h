#pragma once
// The rings of one pass, drivable.

#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/headland/shores.h"

namespace tramline {

/// The closed path that a disc of radius `radius_m` draws whose centre goes along the ring: on the disc's far
/// side. Where the ring turns to the left, the path does so along the disc; an arc of the ring makes an arc
/// smaller by the radius. Precondition: the ring's arcs are larger than the radius.
Path closed_path(const LevelRing& ring, double radius_m);

/// Pass `number` round all boundaries that have so many.
std::vector<HeadlandPass> pass_rings(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                     int number);

}  // namespace tramline
