#pragma once
// Converts worked land recorded as polygons to steps of a drive.

#include <vector>

#include "tramline/coverage/drive/step_maker.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

struct ShapeDrive {
  FurtherWork work;    ///< a step for each worked shape; lines join their middles
  double width_m = 0;  ///< the largest recorded width, else the extent of most shapes square to the way; > 0
  /// Time between consecutive shapes, counted once for units side by side; NaN without times.
  double worked_s = 0;
};

/// The shapes of a log in its order. Those of a unit that follow one another within max_gap_s and lie no
/// further apart than max_step_m are one run. A shape with up to four corners is a quad, any other is divided
/// into triangles; one whose rings cross is repaired first. A shape without a known state of work counts as
/// DriveSettings::unknown_work says. Preconditions: local positions, in order of time; every fix has a shape.
/// O(corners · log).
ShapeDrive shape_drive(const WorkLog& log, const DriveSettings& drive);

}  // namespace tramline::coverage
