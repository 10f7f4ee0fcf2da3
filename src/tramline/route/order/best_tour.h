#pragma once
// The order and the directions in which lines are driven.

#include <cstddef>
#include <vector>

#include "tramline/model/field.h"
#include "tramline/route/order/lines.h"

namespace tramline::order {

/// A tour with short hops. The cost of a hop is its length, plus the extra length of the way round obstacles
/// and bays of the field, plus a working width where it does not lead to a neighbouring track: driving up and
/// down is kept where nothing is gained by leaving it. Where hops still lead through obstacles or far outside
/// the field, an order with fewer such hops is chosen if its hops are no more than a fifth longer. Along
/// straight lines the hops are never longer than 1.2 times those of nearest_neighbour() from the
/// first line or from where the tour begins, nor longer than
/// those of track_by_track() but for up to a fifth where fewer of them lead through obstacles or far outside
/// the field. Where the first line comes in the second half, the tour is turned round.
/// Deterministic; about O(n log n) evaluations of hops.
/// Precondition: lines are ordered by subfield, track and position along it.
Tour best_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m);

/// Block by block, each in the order of skip_pattern(): no hop within a block leads to a track closer than
/// `jump` tracks, where the block has enough. Otherwise as block_by_block(). Preconditions: those of
/// best_tour(), jump ≥ 1.
Tour skip_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m, std::size_t jump);

/// Block by block, and so on each side of an obstacle by itself, each in the order of land_pattern().
/// Otherwise as block_by_block(). Preconditions: those of best_tour(), land ≥ 1.
Tour land_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m, std::size_t land);

/// The pieces of the lines as the tour drives them.
std::vector<TrackPiece> pieces_on(const Tour& tour, const std::vector<WorkedLine>& lines);

}  // namespace tramline::order
