#pragma once
// Where a track's arrow head goes.

#include <optional>
#include <utility>

#include "tramline/model/track.h"

namespace tramline::render {

/// The place on a straight part of the piece, at least half of `room_m` from where that part ends or
/// leaves the box `seen`, that is nearest to the middle of what is seen of the piece; nullopt where no
/// straight part shows more than `room_m`. Precondition: start != end.
std::optional<Point> arrow_place(const TrackPiece& piece, double room_m, const Box& seen);

/// The part of segment ab inside the box; nullopt where it has no length.
std::optional<std::pair<Point, Point>> clipped(Point a, Point b, const Box& box);

}  // namespace tramline::render
