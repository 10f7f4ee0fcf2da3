#include "tramline/turns/outline/run_in.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/turns/outline/towed_motion.h"

namespace tramline {

double lateral_error_m(Angle drawbar_to_line, double drawbar_m, double after_m) {
  assert(drawbar_m > 0);
  const double angle =
      2 * std::atan(std::tan(0.5 * drawbar_to_line.radians()) * std::exp(-after_m / drawbar_m));
  return drawbar_m * std::sin(angle);
}

double run_in_m(Angle drawbar_to_line, double drawbar_m, double tolerance_m) {
  assert(drawbar_m > 0 && tolerance_m > 0);
  if (tolerance_m >= drawbar_m) return 0;
  const double tangent = std::abs(std::tan(0.5 * drawbar_to_line.radians()));
  const double wanted = std::tan(0.5 * std::asin(tolerance_m / drawbar_m));
  return tangent > wanted ? drawbar_m * std::log(tangent / wanted) : 0;
}

double lateral_error_m(const SteeredPath& path, const Outline& outline, double straight_m) {
  return lateral_error_m(TowedMotion(path, outline).angle_at_end(), outline.drawbar_m, straight_m);
}

double run_in_m(const SteeredPath& path, const Outline& outline, double tolerance_m) {
  return run_in_m(TowedMotion(path, outline).angle_at_end(), outline.drawbar_m, tolerance_m);
}

}  // namespace tramline
