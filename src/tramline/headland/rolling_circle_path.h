#pragma once
// The path of a turning circle that rolls along the offset line of a pass and heeds only what is ahead of it
// there.

#include <functional>
#include <optional>
#include <vector>

#include "tramline/geometry/offset/offset_curve.h"
#include "tramline/geometry/offset/offset_rings.h"

namespace tramline {

/// The line of the circle's centre while the circle touches one piece of the offset line from the land's
/// side.
struct CentreLine {
  OffsetCurve curve;
  std::size_t offset_boundary = 0;
  std::size_t next = 0;      ///< index of the next one round the ring
  bool straight_on = false;  ///< no kink before the next one
};

/// The centre lines of rings of offset lines, ring by ring. Pieces shorter than kShortestPiece_m are left
/// out.
std::vector<CentreLine> centre_lines_along(const std::vector<OffsetRing>& offset_lines, double radius_m);

/// A position on a centre line.
struct CentrePosition {
  std::size_t centre_line = 0;
  double at = 0;  ///< as on an OffsetCurve: m along a line, rad along an arc
};

/// The piece of a centre line between two positions.
OffsetPiece piece_between(const CentreLine& centre_line, double from, double to);

/// Whether the pass may drive the turning circle's arc about the centre, from where it touches the piece of
/// one centre line to where it touches that of the other.
using ArcFits = std::function<bool(Point centre, Point heading_before, Point heading_after)>;

/// The line of the centre from one position along the centre lines to another (all round the ring where that
/// lies behind). It changes from one centre line to another where the circle touches both pieces: at the
/// first such point ahead where `fits` accepts the circle's arc, however many centre lines that leaves out.
/// So each arc is on the land, but the circle need not be. nullopt where there is no such line. O(n²) for n
/// centre lines on the way.
std::optional<OffsetRing> rolling_circle_path(const std::vector<CentreLine>& centre_lines,
                                              CentrePosition from, CentrePosition to, const ArcFits& fits);

/// The lines of the centre along a whole ring of the offset line.
struct RollingCirclePaths {
  std::optional<OffsetRing> closed;  ///< where the circle gets all the way round
  std::vector<OffsetRing> open;      ///< otherwise from each kink that it cannot get round to the next one
};

/// The lines of the centre along the ring of centre line `start`. The circle changes centre lines as in
/// rolling_circle_path(), but leaves out no more than `most_skipped_m` of centre lines between these two, nor
/// twice that with their own parts (the tip of a wedge has none in between): where that is impossible the
/// line ends at the kink and the next one begins behind it. O(n²) for n centre lines of the ring.
RollingCirclePaths rolling_circle_paths(const std::vector<CentreLine>& centre_lines, std::size_t start,
                                        const ArcFits& fits, double most_skipped_m);

}  // namespace tramline
