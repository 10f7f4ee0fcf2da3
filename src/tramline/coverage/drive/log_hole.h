#pragma once
// The ground that a machine may have worked while its log has no fixes.

#include <limits>
#include <optional>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/angle.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The machine on one side of a hole in its log.
struct HoleEnd {
  double time_s = std::numeric_limits<double>::quiet_NaN();
  Point place;                     ///< the middle of what works
  std::optional<Heading> heading;  ///< nullopt: not known
  Boom working;                    ///< sections at work
};

/// A machine that was at work on both sides drove straight from one to the other if its headings differ from
/// the straight way by no more than this, ...
inline constexpr Angle kStraightOn = Angle::degrees(30);
/// ... or if it was at least so fast on it, by its usual speed: then it did nothing else meanwhile.
inline constexpr double kLeastOfUsual = 0.5;
/// It was no faster than this, by its usual speed, ...
inline constexpr double kMostOfUsual = 2;
/// ... and where that is not known yet, than this, m/s.
inline constexpr double kFastestWork_mps = 12;

/// How fast a machine drives at work, from its steps so far.
class UsualSpeed {
 public:
  /// Where it all but stands (less than 0.3 m/s) it does not count.
  void add(double way_m, double seconds);
  /// NaN before 10 s of driving are known.
  double mps() const;

 private:
  double way_m_ = 0;
  double seconds_ = 0;
};

/// The straight strip from one end to the other, a quad for each stretch across the machine that works at
/// both; none where it is not plausible that the machine drove so (see above). Without times only headings
/// decide, and where they are not known either, nothing speaks against it. `quads`: the shape of those
/// before and behind the strip, which fits them. O(sections²).
std::vector<Quad> hole_strip(const HoleEnd& from, const HoleEnd& to, double usual_mps, QuadShape quads);

}  // namespace tramline::coverage
