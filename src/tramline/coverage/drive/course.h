#pragma once
// The heading of a machine whose log has none, derived from the course of its antenna.

#include <optional>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/point.h"

namespace tramline::coverage {

/// Shorter steps have no direction.
inline constexpr double kLeastStep_m = 0.02;
/// A course is computed over at least this distance: a centimetre of noise turns it by two degrees at most.
inline constexpr double kCourseBase_m = 0.25;
/// A machine reverses if its course differs from the heading so far by more than this.
inline constexpr Angle kReversing = Angle::degrees(120);

/// Whether a machine with this heading that moves along this course goes backwards.
bool reverses(Heading heading, Heading course);

/// Derives the heading from successive positions. It is kept while the machine stands, and is opposite to the
/// course where the machine reverses.
class Course {
 public:
  /// The heading at the next position; nullopt before the machine has moved. O(1).
  std::optional<Heading> at(Point position);
  void forget();

 private:
  std::vector<Point> trail_;  ///< some of the last positions, the newest last
  std::optional<Heading> heading_;
};

}  // namespace tramline::coverage
