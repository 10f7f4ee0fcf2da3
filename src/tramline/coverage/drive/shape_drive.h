#pragma once
// Worked ground that a log has as polygons, as steps of a drive.

#include <vector>

#include "tramline/coverage/drive/step_maker.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

struct ShapeDrive {
  FurtherWork work;    ///< a step for each shape that was worked; lines join their middles
  double width_m = 0;  ///< the widest recorded, else of most shapes square to the way; > 0
  double worked_s =
      0;  ///< between shapes that follow one another, units side by side once; NaN without times
};

/// The shapes of a log in its order. Those of a unit that follow one another within max_gap_s and lie no
/// further apart than max_step_m are one run. A shape with up to four corners is a quad, any other is cut
/// into triangles; one whose rings cross is mended first. A shape that is not known to have worked counts as
/// DriveSettings::unknown_work says. Preconditions: local positions, in order of time; every fix has a
/// shape. O(corners · log).
ShapeDrive shape_drive(const WorkLog& log, const DriveSettings& drive);

}  // namespace tramline::coverage
