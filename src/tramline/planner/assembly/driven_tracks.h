#pragma once
// The pieces of a candidate in the order in which they are driven.

#include <cstddef>
#include <vector>

#include "tramline/planner/candidate/candidate.h"

namespace tramline {

/// A piece as it was laid.
struct LaidPlace {
  std::size_t subfield = 0;
  std::size_t piece = 0;  ///< of LaidTracks::pieces
};

/// The tracks as driven.
struct Driven {
  std::vector<TrackPiece> pieces;
  std::vector<LaidPlace> laid;  ///< by piece
  std::vector<bool> back;       ///< by piece: driven against its track
};

/// The pieces of a candidate by subfield, track and place along it: not in driving order. Curved ones say
/// what they would overlap by themselves, without detours (overlap_by_piece()).
std::vector<TrackPiece> track_pieces(const SearchTask& task, const Candidate& candidate);

/// The same in the order and the way round in which they are driven (order::best_tour()).
/// Connections between pieces are not planned.
Driven driven_tracks(const SearchTask& task, const Candidate& candidate);

/// The path of a piece in the field's frame, from one end to the other; of a straight one without its
/// detours.
Path line_of(const LaidPiece& piece, const StripGrid& grid);

}  // namespace tramline
