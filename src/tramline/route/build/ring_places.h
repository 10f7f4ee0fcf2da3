#pragma once
// Where closed headland passes may be entered and left, and how soon at the earliest.

#include <array>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/headland.h"
#include "tramline/model/machine.h"
#include "tramline/route/connection/least_seconds.h"

namespace tramline {

/// Places of the axle on a closed pass, at equal distances along it: half a metre at most, or as much more as
/// 1000 places of a long pass are apart.
struct RingPlaces {
  std::array<std::vector<Pose>, 2> senses;  ///< in driving order, each way round
  std::array<SteeredPath, 2> lines;         ///< the axle's, likewise
  double step_m = 0;                        ///< from each to the next
};

/// O(p·n) for p places and n segments. Precondition: the pass is closed.
RingPlaces ring_places(const HeadlandPass& pass, const Turning& turning);

/// Lower bounds, s, of ways with the work off from any place of a ring, either way round, to where a work
/// begins; from where a work ended to any place of a ring; and between any places of two rings, in whichever
/// direction it is less: where an implement works behind the axle or ahead of it, the places of the two
/// senses are not the same.
///
/// The least is taken over the places alone. From any other the machine could drive on along the ring to the
/// next place and would be there a step later, or have come from the one before; so it is less by no more
/// than a step, which is taken off, and places near one that is far dearer need no look. Precondition: the
/// machine can drive along the rings. O(p) for p places, of rings O(p²); mostly far less.
/// `lift_m`, `lower_m`: straight on at the end that is no ring.
double least_from_ring(const RingPlaces& ring, const Pose& entered, double lower_m,
                       const LeastSeconds& least);
double least_to_ring(const Pose& left, double lift_m, const RingPlaces& ring, const LeastSeconds& least);
double least_between_rings(const RingPlaces& one, const RingPlaces& other, const LeastSeconds& least);

/// From a point to the ring, or between rings, m: no way is shorter.
double least_distance_m(const RingPlaces& ring, Point p);
double least_distance_m(const RingPlaces& one, const RingPlaces& other);

}  // namespace tramline
