#pragma once
// Positions and sizes of arrow heads.

#include <optional>
#include <vector>

#include "tramline/model/track.h"
#include "tramline/render/page/visible_stretches.h"

namespace tramline::render {

/// The position for the arrow head of a piece, and the driving direction there; nullopt where there is no
/// room. On straight tracks it is on a straight part, at least half of `room_m` from where that part ends or
/// leaves the box `seen`, as near as possible to the middle of the visible part of the piece. On curved ones
/// it is the middle of the longest visible stretch. Precondition: start != end.
std::optional<PointOnLine> arrow_position(const TrackPiece& piece, double room_m, const Box& seen);

/// Positions along a closed path, about `apart_m` from one another, at least one on each visible stretch
/// longer than `room_m`.
std::vector<PointOnLine> arrow_positions_round(const Path& path, double room_m, double apart_m,
                                               const Box& seen);

/// Size of an arrow head on a swath of this width, px, and the interval of swaths that have one: arrow heads
/// stand side by side, and narrow swaths are skipped.
double arrow_size(double swath_px, double text_scale);
int arrow_stride(double swath_px, double arrow_px);

}  // namespace tramline::render
