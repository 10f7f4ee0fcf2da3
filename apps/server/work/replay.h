#pragma once
// Replays a recorded drive at any speed.

#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

#include "server/work/ready_drive.h"
#include "server/work/work_frame.h"
#include "tramline/coverage/live/work_rate.h"

namespace tramline::server {

inline constexpr double kSlowest = 0.1, kFastest = 1000;

/// What one reader gets of a drive: first a frame with all that was worked up to `from_s`, then frames of the
/// fixes as the log's clock, times `speed`, comes to them, and at the end the figures, which are those of
/// evaluate() on the same log. Who asks seldom gets few frames with much in them. For one thread at a time.
class Replay {
 public:
  using Clock = std::chrono::steady_clock;

  /// `from_s`: of the log's clock; NaN: from its beginning. Precondition: speed within kSlowest … kFastest.
  Replay(std::shared_ptr<const ReadyDrive> drive, double from_s, double speed);

  /// What is next; nothing where that takes longer than `most`. Nothing follows the end.
  WorkEvent next(std::chrono::milliseconds most);
  bool ended() const { return ended_; }

 private:
  void work_until(double clock_s, Clock::time_point until);
  void work(const Fix& fix);
  double due_s(Clock::time_point now) const;
  Clock::time_point due_at(double clock_s) const;
  WorkFigures figures() const;
  WorkFrame frame();

  std::shared_ptr<const ReadyDrive> drive_;
  double from_s_;
  double speed_;
  coverage::WorkedDrive worked_;
  coverage::WorkRate rate_;
  coverage::SeenWork seen_;
  std::size_t driven_ = 0;  ///< fixes
  std::size_t shown_ = 0;   ///< of them in frames
  std::vector<Point> line_;
  bool begun_ = false;
  bool ended_ = false;
  Clock::time_point start_, last_frame_;
};

}  // namespace tramline::server
