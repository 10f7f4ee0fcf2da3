#pragma once
// A recorded drive that can be replayed at any time.

#include <cstddef>
#include <vector>

#include "request/evaluate_input.h"
#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/work_log.h"

namespace tramline::server {

/// A log as evaluate() drives it.
struct ReadyDrive {
  coverage::PreparedLog ready;
  app::WorkGround ground;
  coverage::EvaluateSettings settings;
  std::vector<double> clock_s;  ///< when each fix came, never earlier than the one before
  double from_s() const { return clock_s.front(); }
  double to_s() const { return clock_s.back(); }
  std::size_t bytes() const;  ///< about
};

/// When the fixes of a log came, by its clock: a fix without a time came with the one before it, or before
/// all times with the first. By their number, a second each, where none has a time. O(fixes).
std::vector<double> release_clock(const std::vector<Fix>& fixes);

/// `read`: as it was read; `ground`: empty without a field. Throws kBadInput like placed_on() and evaluate().
/// O(n log n).
ReadyDrive ready_drive(WorkLog read, app::WorkGround ground, const coverage::EvaluateSettings& settings);

}  // namespace tramline::server
