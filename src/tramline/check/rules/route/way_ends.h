#pragma once
// Ends of lines, from which ways lead off and to which they lead: facts of the rule about the bound of a
// route.

#include <limits>
#include <optional>
#include <vector>

#include "tramline/check/rules/route/driven_places.h"
#include "tramline/check/rules/route/route_facts.h"
#include "tramline/geometry/path/steered_path.h"

namespace tramline::check {

/// The time of a way that there is not.
inline constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// Lines that turn by no more than rounding are straight, as a sine.
inline constexpr double kTurnsByRounding = 1e-6;

/// A side of the convex hull of the land that is too near to where a line ends to turn forward from there.
struct SideAhead {
  Point inwards;      ///< unit vector
  double back_m = 0;  ///< along the line, until it is far enough; infinite: nowhere
};

/// A side that a machine comes parallel to with one of its two headings only: for the other there is no room,
/// or the line is parallel to it itself.
struct SideBeside {
  Point inwards;      ///< unit vector
  Point parallel;     ///< unit vector, that heading
  double turned = 0;  ///< from the way off the line to that heading, rad
  double back_m = 0;  ///< along the line, until there is room for the other; infinite: nowhere
};

/// Where a way leaves a line or enters it, and the axle's line from there on, along which a machine may back
/// out or in: until it has a kink, is sharper than the machine turns, or is turned by more than 30°.
struct WayEnd {
  Pose at;
  Point off;  ///< unit vector, off the line
  std::optional<WorkedCourse> course{};
  double from_m = 0;    ///< the position of `at` along the course
  double sense = 0;     ///< of backing along it: -1 or +1
  double behind_m = 0;  ///< so far behind a bend: ways lead off or to the end of all of the line
  double follows_m = 0;
  bool to_far_end = false;  ///< it follows all of the line
  double turns = 0;         ///< the greatest sine of the angle between the line and `off`
  std::vector<SideAhead> sides{};
  std::vector<SideBeside> beside{};  ///< of a straight line

  Pose backed(double by_m) const;
};

/// An end of a line, with all of the line that it may back along, with what of it is straight from there on,
/// and with what lies behind bends: all bound its ways, by how far it may back or by the heading it keeps.
/// Off the end the machine drives on from behind a bend, unless it backs as far as that.
struct LineEnd {
  WayEnd all;
  std::optional<WayEnd> straight{};  ///< where the line bends
  std::vector<WayEnd> behind{};      ///< each longer than those before
  std::vector<LineStep> line{};      ///< all of it
};

}  // namespace tramline::check
