#pragma once
// The land that a machine may have worked while its log has no fixes.

#include <limits>
#include <optional>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/geometry/angle.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The state of the machine at one end of a hole in its log.
struct HoleEnd {
  double time_s = std::numeric_limits<double>::quiet_NaN();
  Point position;                  ///< the middle of the working sections
  std::optional<Heading> heading;  ///< nullopt: not known
  Boom working;                    ///< sections at work
};

/// A machine that was at work at both ends is assumed to have driven straight from one to the other if its
/// headings differ from the straight way by no more than this, ...
inline constexpr Angle kStraightOn = Angle::degrees(30);
/// ... or if its speed on that way was at least this share of its usual speed, so that it had no time for
/// anything else.
inline constexpr double kLeastOfUsual = 0.5;
/// It was no faster than this multiple of its usual speed, ...
inline constexpr double kMostOfUsual = 2;
/// ... or, where that is not known yet, no faster than this, m/s.
inline constexpr double kFastestWork_mps = 12;

/// The usual speed of a machine at work, from its steps so far.
class UsualSpeed {
 public:
  /// Steps at less than 0.3 m/s do not count.
  void add(double way_m, double seconds);
  /// NaN before 10 s of driving are known.
  double mps() const;

 private:
  double way_m_ = 0;
  double seconds_ = 0;
};

/// The straight strip from one end to the other, with a quad for each stretch across the machine that works
/// at both; none where it is not plausible that the machine drove straight (see above). Without times only
/// headings decide; where these are not known either, driving straight counts as plausible. `quads`: the
/// shape of the quads before and after the strip, which the strip matches. O(sections²).
std::vector<Quad> hole_strip(const HoleEnd& from, const HoleEnd& to, double usual_mps, QuadShape quads);

}  // namespace tramline::coverage
