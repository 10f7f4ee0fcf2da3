#pragma once
// Where a machine is and where it goes on to.

#include <limits>
#include <optional>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/angle.h"
#include "tramline/geometry/point.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// At present speed and heading.
struct Motion {
  Point place;  ///< the middle of what works, local metres
  Heading heading;
  double speed_mps = 0;  ///< ahead; 0 for a machine that stands or backs
};

/// Follows the motion of a drive, fix by fix.
class MotionTrack {
 public:
  /// `place`, `heading`: of the implement at the fix. The speed is the fix's own, or by the way since the one
  /// before where the drive went on from there.
  void add(const Fix& fix, Point place, std::optional<Heading> heading, Continuity continuity);
  /// At the last fix; nullopt where the heading or the speed is not known.
  std::optional<Motion> motion() const { return motion_; }

 private:
  std::optional<Motion> motion_;
  Point place_;
  double time_s_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace tramline::coverage
