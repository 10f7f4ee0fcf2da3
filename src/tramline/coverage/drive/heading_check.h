#pragma once
// Compares the headings of a log with the way driven.

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/evaluate_settings.h"
#include "tramline/geometry/angle.h"
#include "tramline/geometry/point.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// The direction of the way is taken over at least this distance: noise of 10 cm at either end turns it by
/// less than a third of kHeadingOff.
inline constexpr double kHeadingBase_m = 1;
/// Below this speed headings and courses are noise, as those of receivers that follow from movement are.
inline constexpr double kHeadingSpeed_mps = 0.5;
/// A heading contradicts the way if it differs by more than this, and if its opposite does, too: a machine
/// that backs is no contradiction. An antenna far in front of the turning axle moves up to 30° off the
/// heading in tight turns.
inline constexpr Angle kHeadingOff = Angle::degrees(45);
/// The headings of a log contradict the way driven if more than this share of its steps is off. Of 16 logs of
/// real machines none has more than 0.01; read as angles of the other kind, none has less than 0.07 ...
inline constexpr double kHeadingShare = 0.05;
/// ... of at least this many.
inline constexpr std::size_t kLeastHeadingSteps = 10;

/// The heading of a fix under a reading; undefined (NaN) where the log has none, and for kFromTrack.
Heading heading_read_as(HeadingReading reading, const Fix& fix);

/// Whether a machine with this heading neither drives nor backs along this course (kHeadingOff).
bool contradicts(Heading heading, Heading course);

/// Compares heading after heading with the way from one fix to a later one: the first at least kHeadingBase_m
/// away, joined to it without interruption, and reached at no less than kHeadingSpeed_mps (where times are
/// known). Whether the machine works does not matter.
class HeadingCheck {
 public:
  /// The next fix of its unit. Amortised O(1).
  void add(const Fix& fix, Continuity continuity);
  /// The finding for headings that are read so; nullopt where they do not contradict the way, or are ignored.
  /// The suggested reading is the one with the fewest steps off if that reading does not contradict the way,
  /// and from-track otherwise.
  std::optional<HeadingContradiction> contradiction(HeadingReading reading) const;

 private:
  struct Tally {
    std::size_t off = 0;
    std::size_t record = 0;  ///< of the first
    double time_s = std::numeric_limits<double>::quiet_NaN();
    Point at;
  };
  struct Begin {
    Point position;
    double time_s = 0;
  };
  const Tally& tally(HeadingReading reading) const {
    return reading == HeadingReading::kMath ? math_ : compass_;
  }
  bool contradictory(const Tally& tally) const;
  static void count(Tally& tally, Heading heading, Heading course, const Fix& fix);

  std::map<int, Begin> begin_;  ///< of each unit
  std::size_t steps_ = 0;
  Tally compass_, math_;
};

/// The sentence for it, with the option to be given.
std::string warning_on(const HeadingContradiction& found, Clock clock);

}  // namespace tramline::coverage
