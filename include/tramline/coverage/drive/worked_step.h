#pragma once
// The work of a machine between two fixes: the input of every coverage engine.

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The land that one run of adjacent working sections works between two fixes (Zhang §2.1): rear left, rear
/// right, front right, front left. P' is always the left one, unlike in Zhang eqs. 3 and 4, which change
/// sides with the heading. It may cross itself where the machine turns on the spot (a bow-tie: two triangles,
/// both worked), be run through in either sense where it reverses, and be empty where it stands.
using Quad = std::array<Point, 4>;

/// The shape of the quads of a step.
enum class QuadShape {
  kHeading,  ///< each end square to the heading there (Zhang eqs. 3 and 4, but with left always left)
  kSegment,  ///< a rectangle along the step
};

/// Whether a fix is joined to the previous fix of its unit.
enum class Continuity { kBroken, kJoined };

/// The origin of a quad: the run of sections that worked it, and the part of the step's time in which it did.
struct QuadOrigin {
  Section section;  ///< offsets from the machine's middle, metres, positive to the left
  double from = 0;  ///< share of the step's time, 0 to 1
  double until = 1;
};

/// One step of the drive. Frame: local metres.
struct WorkedStep {
  std::vector<Quad> quads;
  int run = 0;          ///< number of the unbroken stretch of work, from 0 in order of time
  double travel_m = 0;  ///< driven along the run up to the end of the step
  /// Length of its own trail, back from the end of the step: the step itself and the last w of travel before
  /// it. Land shared with quads of the run whose travel_m lies within that trail does not count as worked
  /// again.
  double reach_m = 0;
  std::size_t fix = 0;  ///< index of the fix at the end of the step

  // Values from which the applied amount follows; unknown for the steps of a plan.
  std::vector<QuadOrigin> origins = {};  ///< one for each quad
  /// Distance driven by the middle of the working sections.
  double way_m = std::numeric_limits<double>::quiet_NaN();
  double seconds = std::numeric_limits<double>::quiet_NaN();  ///< time with the work on, including standing
                                                              ///< before the step
  double rate_before_per_ha = std::numeric_limits<double>::quiet_NaN();  ///< logged at its beginning
  double rate_after_per_ha = std::numeric_limits<double>::quiet_NaN();   ///< logged at its end
};

}  // namespace tramline::coverage
