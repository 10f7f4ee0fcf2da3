#pragma once
// The heading of a machine whose log has none: from the course of its antenna.

#include <optional>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/point.h"

namespace tramline::coverage {

/// Shorter steps have no direction.
inline constexpr double kLeastStep_m = 0.02;
/// A course is taken over this distance at least: a centimetre of noise turns it by two degrees at most.
inline constexpr double kCourseBase_m = 0.25;
/// A course further than this from the heading so far is that of a machine that reverses.
inline constexpr Angle kReversing = Angle::degrees(120);

/// Whether a machine that points there and moves along the course goes backwards.
bool reverses(Heading heading, Heading course);

/// Heading place by place. It is held where the machine stands, and turned round where it reverses.
class Course {
 public:
  /// The heading at the next place; nullopt before it has moved. O(1).
  std::optional<Heading> at(Point place);
  void forget();

 private:
  std::vector<Point> trail_;  ///< some of the last places, the newest last
  std::optional<Heading> heading_;
};

}  // namespace tramline::coverage
