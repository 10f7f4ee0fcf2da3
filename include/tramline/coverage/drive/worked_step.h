#pragma once
// What a machine worked between two fixes: the input of every engine of coverage.

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The ground one run of adjacent working sections works between two fixes (S3.2): rear left, rear right,
/// front right, front left. P' is always the left one, unlike in S3's equations 3 and 4, which change sides
/// with the heading. It may cross itself where the machine turns on the spot (a bow-tie: two triangles, both
/// worked), be run through in either sense where it reverses, and be empty where it stands.
using Quad = std::array<Point, 4>;

/// Which quad a step works.
enum class QuadShape {
  kHeading,  ///< either end square to the heading there (S3's equations 3 and 4, left always left)
  kSegment,  ///< a rectangle along the step
};

/// Whether the drive goes on to a fix from the one before it of its unit.
enum class Continuity { kBroken, kJoined };

/// What worked a quad: a run of sections, and the part of the step's time in which it did.
struct QuadOrigin {
  Section section;  ///< metres left of the machine's middle
  double from = 0;  ///< shares of the step
  double until = 1;
};

/// One step of the drive. Frame: local metres.
struct WorkedStep {
  std::vector<Quad> quads;
  int run = 0;          ///< an unbroken stretch of work; numbered from 0 in order of time
  double travel_m = 0;  ///< driven along the run up to the front of the step
  /// Its own trail, back from its front: the step itself, and the last w of travel before it. Quads of the
  /// run whose travel_m is within that are not worked again by what they share with this one.
  double reach_m = 0;
  std::size_t fix = 0;  ///< index of the fix at the step's front

  // What the amount that was applied follows from; not known of the steps of a plan.
  std::vector<QuadOrigin> origins = {};                       ///< as many as quads
  double way_m = std::numeric_limits<double>::quiet_NaN();    ///< of the middle of what works
  double seconds = std::numeric_limits<double>::quiet_NaN();  ///< with the work on, standing before it too
  double rate_before_per_ha = std::numeric_limits<double>::quiet_NaN();  ///< logged where it begins
  double rate_after_per_ha = std::numeric_limits<double>::quiet_NaN();   ///< logged where it ends
};

}  // namespace tramline::coverage
