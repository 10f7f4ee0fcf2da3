#pragma once
// In which order and which way round lines are driven.

#include <vector>

#include "tramline/model/field.h"
#include "tramline/planner/order/lines.h"

namespace tramline::order {

/// A tour with short hops. A hop counts its length, what the way round obstacles and round bays of the field
/// takes longer than the straight line, and a working width where it leads elsewhere than to a track beside:
/// going up and down is kept to where nothing is gained by leaving it. Where hops still lead through
/// obstacles or far outside the field, an order with fewer of them is taken if its hops are no more than a
/// fifth longer.
/// Along straight lines the hops are never longer than 1.2 times those of nearest_neighbour() from the
/// first line or from where the tour begins, nor longer than
/// those of track_by_track() but for up to a fifth where fewer of them lead through obstacles or far outside
/// the field. Where the first line comes in the second half, the tour is turned round.
/// Deterministic; about O(n log n) looks at hops.
/// Precondition: lines come by subfield, track and place along it.
Tour best_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m);

/// The pieces of the lines as the tour drives them.
std::vector<TrackPiece> pieces_on(const Tour& tour, const std::vector<WorkedLine>& lines);

}  // namespace tramline::order
