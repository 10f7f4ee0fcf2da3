#pragma once
// A turning circle that rolls along the level of a pass, and heeds nothing but what is ahead of it there.

#include <functional>
#include <optional>
#include <vector>

#include "tramline/geometry/level_rings.h"
#include "tramline/geometry/offset_curve.h"

namespace tramline {

/// The circle's centre while it touches one piece of the level from the land's side.
struct Rail {
  OffsetCurve curve;
  std::size_t shore = 0;
  std::size_t next = 0;      ///< round the ring
  bool straight_on = false;  ///< no kink before the next one
};

/// The rails of rings of the level, ring by ring. Pieces shorter than kShortestPiece_m are left out.
std::vector<Rail> rails_along(const std::vector<LevelRing>& level, double radius_m);

/// A place on a rail.
struct RailPlace {
  std::size_t rail = 0;
  double at = 0;  ///< as OffsetCurve's places: m along a line, rad along an arc
};

/// The piece of a rail between two places.
LevelPiece piece_between(const Rail& rail, double from, double to);

/// May the pass drive the turning circle's arc about the centre, from where it touches one rail's piece to
/// where it touches the other's?
using ArcFits = std::function<bool(Point centre, Point heading_before, Point heading_after)>;

/// The way of the centre from one place along the rails to another (all round the ring where that lies
/// behind). From rail to rail it goes where the circle touches both: the first such place ahead where `fits`
/// lets the circle's arc be driven, however many rails that leaves out. So each arc is on the land, but the
/// circle need not be. nullopt: there is no such way. O(n²) for n rails on the way.
std::optional<LevelRing> rolled(const std::vector<Rail>& rails, RailPlace from, RailPlace to,
                                const ArcFits& fits);

/// Ways of the centre along a whole ring of the level.
struct LevelWays {
  std::optional<LevelRing> closed;  ///< where the circle gets all the way round
  std::vector<LevelRing> open;      ///< else, from one kink that it cannot get round to the next one
};

/// Along the ring of rail `start`. From rail to rail the circle goes as rolled() has it, but leaves out no
/// more than `most_skipped_m` of the level at one place: where there is no such way the path ends at the kink
/// and the next one begins behind it. O(n²) for n rails of the ring.
LevelWays ways_along(const std::vector<Rail>& rails, std::size_t start, const ArcFits& fits,
                     double most_skipped_m);

}  // namespace tramline
