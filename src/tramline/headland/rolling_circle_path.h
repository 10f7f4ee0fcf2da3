#pragma once
// A turning circle that rolls along the level of a pass, and heeds nothing but what is ahead of it there.

#include <functional>
#include <optional>
#include <vector>

#include "tramline/geometry/offset/offset_curve.h"
#include "tramline/geometry/offset/offset_rings.h"

namespace tramline {

/// The circle's centre while it touches one piece of the level from the land's side.
struct CentreLine {
  OffsetCurve curve;
  std::size_t offset_boundary = 0;
  std::size_t next = 0;      ///< round the ring
  bool straight_on = false;  ///< no kink before the next one
};

/// The centre_lines of rings of the level, ring by ring. Pieces shorter than kShortestPiece_m are left out.
std::vector<CentreLine> centre_lines_along(const std::vector<OffsetRing>& level, double radius_m);

/// A place on a centre_line.
struct CentrePlace {
  std::size_t centre_line = 0;
  double at = 0;  ///< as OffsetCurve's places: m along a line, rad along an arc
};

/// The piece of a centre_line between two places.
OffsetPiece piece_between(const CentreLine& centre_line, double from, double to);

/// May the pass drive the turning circle's arc about the centre, from where it touches one centre_line's
/// piece to where it touches the other's?
using ArcFits = std::function<bool(Point centre, Point heading_before, Point heading_after)>;

/// The way of the centre from one place along the centre_lines to another (all round the ring where that lies
/// behind). From centre_line to centre_line it goes where the circle touches both: the first such place ahead
/// where `fits` lets the circle's arc be driven, however many centre_lines that leaves out. So each arc is on
/// the land, but the circle need not be. nullopt: there is no such way. O(n²) for n centre_lines on the way.
std::optional<OffsetRing> rolling_circle_path(const std::vector<CentreLine>& centre_lines, CentrePlace from,
                                              CentrePlace to, const ArcFits& fits);

/// Ways of the centre along a whole ring of the level.
struct RollingCirclePaths {
  std::optional<OffsetRing> closed;  ///< where the circle gets all the way round
  std::vector<OffsetRing> open;      ///< else, from one kink that it cannot get round to the next one
};

/// Along the ring of centre_line `start`. From centre_line to centre_line the circle goes as
/// rolling_circle_path() has it, but leaves out no more than `most_skipped_m` of the level at one place:
/// where there is no such way the path ends at the kink and the next one begins behind it. O(n²) for n
/// centre_lines of the ring.
RollingCirclePaths rolling_circle_paths(const std::vector<CentreLine>& centre_lines, std::size_t start,
                                        const ArcFits& fits, double most_skipped_m);

}  // namespace tramline
