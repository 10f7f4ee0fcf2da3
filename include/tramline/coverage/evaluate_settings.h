#pragma once
// How a drive is evaluated.

#include <cstddef>
#include <limits>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// When work and sections switch that differ between two fixes.
enum class Switching {
  kInterpolate,  ///< half way between them
  kStep,         ///< at the second: state and width of a step are those of its first fix
};

/// How fixes become ground.
struct DriveSettings {
  double width_m = std::numeric_limits<double>::quiet_NaN();  ///< where a log does not say
  QuadShape quads = QuadShape::kHeading;
  Switching switching = Switching::kInterpolate;
  double max_gap_s = 10;                    ///< nothing is worked between fixes further apart in time
  double max_step_m = 15;                   ///< nor in place
  double antenna_forward_m = 0;             ///< antenna before the machine's middle
  double antenna_right_m = 0;               ///< antenna right of it
  double implement_behind_m = 0;            ///< what works, behind the machine's middle
  WorkState unknown_work = WorkState::kOn;  ///< on or off: what a fix counts as that does not say
};

/// The engines that areas and regions come from.
enum class EngineKind {
  kExact,  ///< tile_coverage.h
  kMesh,   ///< S3's own (mesh_coverage.h)
};
const char* name(EngineKind kind);  ///< exact, mesh

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

}  // namespace tramline::coverage
