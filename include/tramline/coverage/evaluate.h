#pragma once
// Evaluation of a drive: the land it covered, repeated and missed (Zhang §3.1).

#include <cstddef>
#include <functional>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/evaluate_settings.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// A callback that receives the number of fixes evaluated so far.
using FixProgress = std::function<void(std::size_t done, std::size_t total)>;

/// Work that follows a log, such as that of a repair plan.
struct FurtherWork {
  std::vector<WorkedStep> steps;            ///< runs numbered from 0
  std::vector<std::vector<Point>> lines{};  ///< the path of each run
};

/// A callback that receives the steps of a drive as they are worked.
using StepSink = std::function<void(const WorkedStep&)>;

/// The largest width of the machine at any fix, or DriveSettings::width_m. Throws kBadInput where no width is
/// known. O(fixes).
double working_width_m(const WorkLog& log, const DriveSettings& drive);

/// Evaluates the drive of a log on a field. Fixes are processed in order of time. `field`: the land to work,
/// local metres, oriented; empty: no field, and nothing missed. The caller sets the field id, the frame and
/// the records that readers skipped. `sink` receives every step as well. `further`: work done after the log,
/// on the same land, in runs of its own; it is not passed to the sink and not counted in slices. Throws
/// kBadInput where no width is known, the slices are too many, or fewer than two fixes are left. For a log
/// with WorkLog::shapes these are the work, and nothing is worked between its fixes. O(fixes) and the
/// regions. Precondition: local positions.
Coverage evaluate(WorkLog log, const Region& field, const EvaluateSettings& settings,
                  const FixProgress& progress, const StepSink& sink = {}, const FurtherWork& further = {});

/// The same for given steps, such as those of a plan (plan_steps.h). `width_m`: the width of most of them.
Coverage evaluate(const std::vector<WorkedStep>& steps, double width_m, const Region& field,
                  const EvaluateSettings& settings);

}  // namespace tramline::coverage
