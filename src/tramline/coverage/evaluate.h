#pragma once
// From a drive to what it covered, repeated and missed (S3.8).

#include <cstddef>
#include <functional>
#include <vector>

#include "tramline/coverage/drive/step_maker.h"
#include "tramline/coverage/engine.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// Slices of one log: for each, the rings of all ground worked so far are put together.
inline constexpr std::size_t kMostSlices = 1000;

/// Which ground that was worked again counts as repeated.
enum class RepeatRule {
  kRun,     ///< what was worked before the machine's own trail (WorkedStep::reach_m): slivers do not count
  kStrict,  ///< all, as in S3
};

struct EvaluateSettings {
  DriveSettings drive;
  EngineKind engine = EngineKind::kExact;
  double mesh_m = 0.05;  ///< S3.3
  RepeatRule repeat = RepeatRule::kRun;
  std::size_t slice = 0;  ///< figures after every so many fixes; 0: none. At most kMostSlices slices
  bool shapes = true;     ///< covered and repeated ground and how often it was worked, as regions too
  bool covered = false;   ///< covered ground as a region where shapes are not asked for
  int threads = 0;        ///< 0: all; the result is the same
};

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
