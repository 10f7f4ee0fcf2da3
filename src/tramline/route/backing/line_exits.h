#pragma once
// Ends of lines, with what the sides of the land near to them ask of ways.

#include <memory>
#include <optional>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/route/backing/heading_reach.h"

namespace tramline {

/// A straight side of the land, or of the gap across a bay of it, that is too near to an end of a line to
/// turn away from.
struct NearSide {
  Point inwards;  ///< unit vector
  double back_m;  ///< far enough from it, along the line; infinite: nowhere
};

/// A side to which a machine can turn one way only: from the heading at which it meets it to that along it.
/// A line along a side is its own heading along it.
struct OneWaySide {
  Point inwards;  ///< unit vector
  Point along;    ///< unit vector: the heading along the side to which it turns
  double angle;   ///< between the heading and `along`, rad, from 0 to less than π/2
  double back_m;  ///< along the line until it could turn the other way as well; infinite: never
};

/// Where a way leaves a line, or enters it.
struct LineExit {
  Pose pose;            ///< of the axle, as it works
  double backing = -1;  ///< along the heading: -1 out of an end, +1 into a beginning
  SteeredPath line{};   ///< from there as far as it turns by little and as the machine could
  double length_m = 0;  ///< of that
  bool whole = false;   ///< to its other end
  double bent = 0;      ///< by how much it turns, as a sine
  double behind_m = 0;  ///< so far along the line behind a bend: ways lead off or to the end of all of it
  std::vector<NearSide> near{};
  std::vector<OneWaySide> one_way{};
};

/// Places that ways get to without a stop, which back along this line at the most.
struct ExitReach {
  std::shared_ptr<const PlacesByHeading> off;     ///< from the exit, off the line
  std::shared_ptr<const PlacesByHeading> beyond;  ///< having backed all along the line, and on
  SteeredPath line;                               ///< the axle's, all of it
};

/// The same followed as far as it goes, only until it bends, and from behind a bend. A way is bounded by all:
/// where bends are followed, less is known of the heading from which it goes on.
struct LineExits {
  LineExit whole;
  std::optional<LineExit> straight{};     ///< of a line that begins straight and bends
  std::optional<LineExit> behind_bend{};  ///< of a line that turns far, the longest part
  std::optional<ExitReach> reached{};     ///< where it is followed
};

}  // namespace tramline
