#pragma once
// The texts of a plan file about pieces, detours and obstacles.

#include <string>
#include <vector>

#include "tramline/model/track.h"

namespace tramline::io {

/// Obstacles for people, counted from 1: "3, 7".
std::string obstacles_text(const std::vector<std::size_t>& indices);
/// The inverse. Throws Error(kBadInput) that begins with `place` where the text is of another form.
std::vector<std::size_t> obstacles_from_text(const std::string& text, const std::string& place);

/// The obstacles that the piece goes round, ascending, each once: "3, 7".
std::string obstacles_avoided(const TrackPiece& piece);
/// One word for each detour: "left, right".
std::string sides_text(const TrackPiece& piece);

/// The kind of a piece: straight, detour or curved, by the names of plan_layers.h.
const char* kind_of(const TrackPiece& piece);

/// The path of a piece in the file: centre_line(piece), or for a piece without length a path without length.
Path written_path(const TrackPiece& piece);

/// JSON: for each detour the first and the last of its segments in written_path(piece), from 0, its
/// side and its obstacles, from 1.
std::string detours_text(const TrackPiece& piece);

/// The inverse: start, end and detours of a piece with that path that is not curved. Throws Error(kBadInput)
/// that begins with `place` where the text is malformed, names segments that the path does not have, or omits
/// segments that are not straight lines between the detours. O(n).
TrackPiece piece_from_text(const Path& path, const std::string& detours, const std::string& place);

/// A curved piece along that path. Throws Error(kBadInput) that begins with `place` where there are detours:
/// a curved piece has none.
TrackPiece curved_piece(const Path& path, const std::string& detours, const std::string& place);

}  // namespace tramline::io
