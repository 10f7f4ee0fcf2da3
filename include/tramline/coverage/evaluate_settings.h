#pragma once
// Settings of the evaluation of a drive.

#include <cstddef>
#include <limits>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The moment at which work or sections switch if their states differ between two fixes.
enum class Switching {
  kInterpolate,  ///< half way between them
  kStep,         ///< at the second fix: state and width of a step are those of its first fix
};

/// What the headings of a log mean.
enum class HeadingReading {
  kCompass,    ///< clockwise from north
  kMath,       ///< anticlockwise from east
  kFromTrack,  ///< ignored: headings follow from the positions
};
const char* name(HeadingReading reading);  ///< compass, math, from-track

/// Settings by which fixes become worked land.
struct DriveSettings {
  double width_m = std::numeric_limits<double>::quiet_NaN();  ///< used where a log does not give the width
  QuadShape quads = QuadShape::kHeading;
  HeadingReading headings = HeadingReading::kCompass;
  Switching switching = Switching::kInterpolate;
  double max_gap_s = 10;                    ///< nothing is worked between fixes further apart in time
  double max_step_m = 15;                   ///< nor between fixes further apart in position
  double antenna_forward_m = 0;             ///< antenna in front of the machine's middle
  double antenna_right_m = 0;               ///< antenna right of it
  double implement_behind_m = 0;            ///< working implement behind the machine's middle
  WorkState unknown_work = WorkState::kOn;  ///< state assumed for a fix that does not give one: on or off
};

/// The engines that compute areas and regions.
enum class EngineKind {
  kExact,  ///< tile_coverage.h
  kMesh,   ///< Zhang's own (mesh_coverage.h)
};
const char* name(EngineKind kind);  ///< exact, mesh

/// The most slices of one log: for each of them the rings of all land worked so far are assembled.
inline constexpr std::size_t kMostSlices = 1000;

/// Which land that was worked again counts as repeated.
enum class RepeatRule {
  kRun,     ///< land worked before the machine's own trail (WorkedStep::reach_m): slivers are apart
  kStrict,  ///< all land worked twice or more, as in Zhang §3.1; there are no slivers then
};

struct EvaluateSettings {
  DriveSettings drive;
  EngineKind engine = EngineKind::kExact;
  double mesh_m = 0.05;  ///< Zhang §2.3.1
  RepeatRule repeat = RepeatRule::kRun;
  std::size_t slice = 0;  ///< number of fixes per slice; 0: no slices. At most kMostSlices slices
  bool shapes = true;     ///< also give covered land, repeated land and land by times worked as regions
  bool covered = false;   ///< give covered land as a region even without shapes
  int threads = 0;        ///< 0: all; the result is the same
};

}  // namespace tramline::coverage
