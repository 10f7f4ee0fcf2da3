#include "tramline/io/fixes/course_heading.h"

#include <cmath>

namespace tramline::io {

Heading heading_of_degrees(double degrees) {
  if (!(std::abs(degrees) <= 720)) return {};
  return Heading::clockwise_from_north(Angle::degrees(degrees));
}

Heading heading_of_course(double course_deg, double speed_mps) {
  return speed_mps > kCourseHolds_mps ? heading_of_degrees(course_deg) : Heading();
}

}  // namespace tramline::io
