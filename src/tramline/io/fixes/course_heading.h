#pragma once
// Headings derived from courses over ground.

#include "tramline/geometry/angle.h"

namespace tramline::io {

/// Below this speed a receiver's course is noise.
inline constexpr double kCourseHolds_mps = 0.5;

/// Any finite angle clockwise from north, degrees; undefined for NaN and beyond +-720.
Heading heading_of_degrees(double degrees);

/// The course as a heading; undefined at kCourseHolds_mps and below, and where the speed is not known (NaN).
Heading heading_of_course(double course_deg, double speed_mps);

}  // namespace tramline::io
