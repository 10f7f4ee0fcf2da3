#pragma once
// How far along a line a machine may back with about the same heading: facts of the rule about the bound of a
// route.

#include <vector>

#include "tramline/check/rules/route/way_ends.h"

namespace tramline::check {

/// A line or arc of the axle's line.
struct LinePiece {
  double length_m = 0;
  double curvature = 0;
};

/// While the implement works the path, in the order in which they are backed along.
std::vector<LinePiece> pieces_from(const WorkedCourse& course, double sense);
/// Those that begin so far along the line or farther.
std::vector<LinePiece> pieces_behind(const WorkedCourse& course, double sense, double from_m);

/// All that it may back along, or as far as that is straight.
enum class Followed { kAll, kStraight };

/// Follows the line from where a way leaves it or enters it: until it has a kink, is sharper than the machine
/// turns, or is turned by more than 30°. Fills in how far that is. Preconditions: course and `at` are set,
/// radius_m > 0.
void follow_line(WayEnd& end, double radius_m, Followed followed);

/// Whether the line has a kink so far along it.
bool kinked_at(const WayEnd& end, double at_m);
/// Whether the machine can drive the piece.
bool can_drive(const LinePiece& piece, double radius_m);

}  // namespace tramline::check
