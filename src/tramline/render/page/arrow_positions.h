#pragma once
// Where arrow heads go, and how large they are.

#include <optional>
#include <vector>

#include "tramline/model/track.h"
#include "tramline/render/page/seen_stretches.h"

namespace tramline::render {

/// The place for the arrow head of a piece, and the driving direction there; nullopt where there is no room.
/// On straight tracks it is on a straight part, at least half of `room_m` from where that part ends or leaves
/// the box `seen`, as near as can be to the middle of what is seen of the piece. On curved ones it is the
/// middle of the longest stretch that is seen. Precondition: start != end.
std::optional<PlaceOnLine> arrow_place(const TrackPiece& piece, double room_m, const Box& seen);

/// Places along a closed path, about `apart_m` from one another, at least one on each stretch that is seen
/// and longer than `room_m`.
std::vector<PlaceOnLine> arrow_places_round(const Path& path, double room_m, double apart_m, const Box& seen);

/// Size of an arrow head on a swath of this width, and every how many swaths have one: they stand side by
/// side, and leave out some where swaths are narrow. px.
double arrow_size(double swath_px, double text_scale);
int arrow_stride(double swath_px, double arrow_px);

}  // namespace tramline::render
