#include "tramline/coverage/drive/motion.h"

#include <algorithm>
#include <cmath>

namespace tramline::coverage {

void MotionTrack::add(const Fix& fix, Point position, std::optional<Heading> heading, Continuity continuity) {
  const bool joined = continuity == Continuity::kJoined;
  const Point way = position - position_;
  const double measured_mps = joined ? length(way) / (fix.time_s - time_s_) : std::nan("");
  position_ = position;
  time_s_ = fix.time_s;
  motion_.reset();
  const double speed_mps = std::isfinite(fix.speed_mps) ? fix.speed_mps : measured_mps;
  if (!heading || !std::isfinite(speed_mps)) return;
  const bool backs = joined && dot(way, heading->unit()) < 0;
  motion_ = Motion{position, *heading, backs ? 0 : std::max(0.0, speed_mps)};
}

}  // namespace tramline::coverage
