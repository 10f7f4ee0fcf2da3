#pragma once
// Curved tracks as a plan has them: in driving order.

#include <vector>

#include "tramline/model/field.h"
#include "tramline/model/track.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// How pieces are written down.
struct Writing {
  double width_m = 0;
  bool curved = true;  ///< with their path, even where it is straight
};

/// The tracks as driven, and of every piece of them the part of the ground it lies in and whether it is
/// driven against the reference.
struct Driven {
  std::vector<TrackPiece> pieces;  ///< in driving order
  std::vector<int> subfields;      ///< by piece of the tracks
  std::vector<bool> back;          ///< by piece of the tracks
};

/// The tracks as they are laid, each the same way: not in driving order.
std::vector<TrackPiece> track_pieces(const LaidTracks& tracks, const Region& parts, const Writing& writing);

/// In the order and the way round of order::best_tour(); each part of the ground is a subfield. What a piece
/// is said to overlap is what it would without detours (add_overlaps()).
Driven driven_tracks(const LaidTracks& tracks, const Region& parts, const Field& field,
                     const Writing& writing);

/// The part of the ground a piece lies in.
int subfield_of(const Region& parts, const LaidPiece& piece, double width_m);

}  // namespace tramline
