#pragma once
// Plans small enough to be known by hand.

#include <set>
#include <string>
#include <vector>

#include "support/box_ring.h"
#include "tramline/check/verify.h"
#include "tramline/model/plan.h"

namespace tramline::testing_plans {

using testing_support::box;

/// Tallies, cost and layers made to agree with the tracks and passes, so that a fault made on purpose is the
/// only one. Precondition: shapes and pieces are sound.
Plan settled(Plan plan);

/// 100 m × 30 m, ten swaths of 3 m driven east and west in turn: nothing over, nothing missed.
Plan rectangle_plan();

/// Right triangle 100 m × 40 m, swaths of 4 m along the long leg; cot φ = 2.5 at the hypotenuse. All
/// ends lie where the share `f` of the width is inside.
Plan triangle_plan(EndRule rule, double f);

/// The rectangle with an obstacle of 20 m × 2 m across two swaths: four stops, two encounters.
Plan obstacle_plan();

/// The same with land given up in place of the obstacle.
Plan given_up_plan();

/// The rectangle parted by an oblique border (cot φ = 2/3); both sides run on until nothing is missed.
Plan two_subfields_plan();

/// The rectangle with a ditch of 3 m across all swaths: ten crossings.
Plan crossing_plan();

/// A square pole, half a metre wide and across the axes, as a hole of a field.
inline constexpr double kPoleHalf_m = 0.25;

/// What a plan says where a track meets obstacles: the chosen way is possible, and costs least.
Encounter encounter_on(const TrackPiece& piece, Point at, std::vector<std::size_t> obstacles, Passing chosen);

/// Three arcs of one radius that leave the piece's line by `away_m` at `along_m` from its start and
/// come back: √(4·r·h − h²) before and behind.
Detour bulge(const TrackPiece& piece, double along_m, double away_m, double radius_m, Passing side,
             std::vector<std::size_t> obstacles);
/// By how much such a bulge has to leave the line for a swath of `half_m` to keep `clearance_m` from a
/// pole on it. Precondition: radius_m > half_m + clearance_m + kPoleHalf_m.
double away_from_pole(double radius_m, double half_m, double clearance_m);

/// The rectangle with a pole on track 5 at x = 50 and one on track 8 at x = 30. Their pieces go round
/// them by bulges of the machine's radius, 6 m, that touch the poles: east, on the left; west, on the right.
Plan poles_plan(double clearance_m = 0);

/// The rectangle with an obstacle that is open to the west: a bay 11.5 m wide between its arms at y = 12 and
/// y = 23.5, closed at x = 60. The southern arm ends in a hook at x = 45 that reaches 1 m into track 5's
/// strip: that track goes round it on the left, into the bay, and ends there. Tracks 4 to 8 are cut.
Plan bay_plan();

/// A rectangle with rounded corners driven round counter-clockwise, from the west end of its south side.
/// With a radius of 0 the corners are kinks.
Path rounded_rectangle(double min_x, double min_y, double max_x, double max_y, double radius_m);

/// 100 m × 60 m with passes of 3 m round it, at most two, and swaths of 3 m over the body; corners of
/// 3 m, the machine's radius.
inline constexpr double kCorner_m = 3;
Plan headland_plan(int passes);

/// The same with a ditch of 3 m across the field from south to north: the passes cross it, and the tracks.
Plan headland_and_ditch_plan();

/// The same rectangle without a headland of its own, but one round an obstacle of 20 m × 6 m: one pass that
/// swings wide at the corners. Four tracks are cut there, two of which run on where it is round until nothing
/// is missed.
Plan island_plan();
/// By how much the pass of 3 m keeps off the sides of that obstacle, if it is to keep 1.5 m off its corners.
double wide_corner_m();

/// Between two circles about the origin and two angles.
Ring ring_sector(double inner_m, double outer_m, double from_deg, double to_deg);
/// A quarter of a ring between circles of 30 m and 45 m about the origin, from east to north, with five
/// tracks of 3 m along arcs about the same point, driven to and fro.
Plan arcs_plan();
/// A track of that between two angles from the east, anticlockwise, degrees; driven backwards on odd ones.
TrackPiece arc_piece(int track, double from_deg, double to_deg);

/// The same with an obstacle from circle to circle across the third track, between 40° and 50°: two stops.
Plan blocked_arc_plan();

/// The same plan turned by an angle clockwise and then moved.
Plan turned(Plan plan, Angle by, Point move);

/// The names of the rules violated.
std::set<std::string> rules(const check::Verdict& verdict);
using Names = std::set<std::string>;
/// Names of the rules that a plan breaks.
Names found(const Plan& plan);

/// Fails the running test with every violation.
void expect_holds(const Plan& plan);

}  // namespace tramline::testing_plans
