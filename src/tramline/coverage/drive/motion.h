#pragma once
// The motion of a machine: position, heading and speed.

#include <limits>
#include <optional>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/angle.h"
#include "tramline/geometry/point.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Position, heading and speed of a machine at a fix.
struct Motion {
  Point position;  ///< the middle of the working sections, local metres
  Heading heading;
  double speed_mps = 0;  ///< forward speed; 0 for a machine that stands or reverses
};

/// Follows the motion of a drive, fix by fix.
class MotionTrack {
 public:
  /// `position`, `heading`: those of the implement at the fix. The speed is the fix's own or, where the fix
  /// is joined to the previous one, follows from the distance between the two.
  void add(const Fix& fix, Point position, std::optional<Heading> heading, Continuity continuity);
  /// The motion at the last fix; nullopt where the heading or the speed is not known.
  std::optional<Motion> motion() const { return motion_; }

 private:
  std::optional<Motion> motion_;
  Point position_;
  double time_s_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace tramline::coverage
