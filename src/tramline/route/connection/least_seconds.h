#pragma once
// What no way between two works takes less than.

#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {

/// For bounds that hold whatever is rounded. Between places of passes that turn as tightly as the machine the
/// shortest way turns on their circles, and where a rounded coordinate lies inside one it leads once round
/// instead. A slightly tighter machine has no such ways, and none that are longer.
Machine slightly_tighter(Machine machine);

/// Lower bounds of the time of ways with the work off, whatever the land: forwards a shortest Dubins path
/// between the straight lines on which the implement is lifted and lowered; with reversing a shortest path of
/// Reeds and Shepp (1990) at the higher speed and two changes of gear, which a machine with a drawbar in tow
/// cannot drive. One that does not turn in reverse pays for a stop then.
class LeastSeconds {
 public:
  /// `stop_s`: what a stop to back out counts besides its time.
  explicit LeastSeconds(const Machine& machine, double stop_s = 0);

  /// From the axle's pose where one work ends to that where another begins. O(1), allocates nothing.
  double between(const Pose& left, const Pose& entered) const;
  /// The same of ways without reversing.
  double forward(const Pose& left, const Pose& entered) const;
  /// As between(), but at most as large, in a tenth of the time: along the straight line.
  double crude(const Pose& left, const Pose& entered) const;
  /// The same with other distances straight on at both ends than the machine's, m. Where the least time is
  /// `known_s` or more, the answer may be less than it, but is `known_s` at least: so much need not be
  /// computed.
  double between(const Pose& left, double lift_m, const Pose& entered, double lower_m, double known_s) const;
  double lift_m() const { return turning_.lift_m; }
  double lower_m() const { return turning_.lower_m; }
  double turning_speed_mps() const { return turning_.turning_speed_mps; }
  double fastest_mps() const { return fastest_mps_; }
  /// From a gate, or to one.
  double to_gate(Point gate, const Pose& pose) const { return distance(gate, pose.at) / fastest_mps_; }

 private:
  double forward(const Pose& left, double lift_m, const Pose& entered, double lower_m) const;

  Turning turning_;
  double radius_m_;
  bool reverses_;
  double changes_s_;  ///< of gear, and the stop
  double fastest_mps_;
};

}  // namespace tramline
