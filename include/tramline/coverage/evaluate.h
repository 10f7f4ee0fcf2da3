#pragma once
// From a drive to what it covered, repeated and missed (S3.8).

#include <cstddef>
#include <functional>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/evaluate_settings.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Fixes done so far.
using FixProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Work that follows a log, such as that of a repair plan.
struct FurtherWork {
  std::vector<WorkedStep> steps;            ///< runs numbered from 0
  std::vector<std::vector<Point>> lines{};  ///< the way of each run
};

/// Takes the steps of a drive as they are worked.
using StepSink = std::function<void(const WorkedStep&)>;

/// The widest the machine was at any fix, or DriveSettings::width_m. Throws kBadInput where no width is
/// known. O(fixes).
double working_width_m(const WorkLog& log, const DriveSettings& drive);

/// What a log's drive worked of the field. Fixes are taken in order of time. `field`: what was to be worked,
/// local metres, oriented; empty: no field, and nothing missed. Field id, frame and what readers skipped are
/// the caller's. `sink` gets every step too. `further`: work done after the log, on the same ground, in runs
/// of its own; sink and slices know nothing of it. Throws kBadInput where no width is known, the slices are
/// too many, or fewer than two fixes are left. A log with WorkLog::shapes worked these, and nothing between
/// its fixes. O(fixes) and the regions. Precondition: local positions.
Coverage evaluate(WorkLog log, const Region& field, const EvaluateSettings& settings,
                  const FixProgress& progress, const StepSink& sink = {}, const FurtherWork& further = {});

/// The same for steps that are known, such as those of a plan (plan_steps.h). `width_m`: of most.
Coverage evaluate(const std::vector<WorkedStep>& steps, double width_m, const Region& field,
                  const EvaluateSettings& settings);

}  // namespace tramline::coverage
