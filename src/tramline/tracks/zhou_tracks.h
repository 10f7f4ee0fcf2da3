#pragma once
// Zhou's own construction of tracks along a line (§2.3.4: algorithm 1 straight, 2 with bends): each track
// is made from the one before. It serves for comparison; tracks that a machine can follow are made by
// parallel.h and curved_tracks.h.

#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// The line extended along its end tangents across the body (Zhou §2.3.4), the first track w/2 beside it, on
/// either side. The pieces of each track are its rows with any body to work (zhou_track_extent()); together
/// with the parts between them they are the final track. Its offset by w, extended again, is the next
/// (algorithm 2). It buffers every track but the first by w where its rows are w/2 wide to either side:
/// read as w/2. A track without a piece is offset as a whole, until none meets the body's box any more. Kinks
/// stay. Pieces have no `inside_m2`; rows of one family may overlap or leave land between them. Tracks are
/// numbered from the line: 0, 1 … to the right, −1, −2 … to the left; `branch` is the part of the body.
/// Pieces shorter than `min_length_m` (Zhou: 0) are dropped. Preconditions: at least two distinct points; no
/// two consecutive points equal; the body is not empty. For each track a polygon boolean, and O(n²) where it
/// crosses itself.
LaidTracks zhou_tracks(const std::vector<Point>& line, double width_m, const Region& body,
                       double min_length_m);

/// The line with straight ends long enough to leave the body's box behind; shorter where they would meet the
/// line.
Path extended_over(const std::vector<Point>& line, double width_m, const Region& body);

}  // namespace tramline
