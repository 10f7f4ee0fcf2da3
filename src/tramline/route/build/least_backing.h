#pragma once
// How far a machine has to back where the sides of the field leave it no way forward.

#include <optional>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/machine.h"

namespace tramline {

/// A straight side of the land, or of the gap across a bay of it, that is too near to an end of a line to
/// turn away from.
struct NearSide {
  Point inwards;  ///< unit vector
  double back_m;  ///< far enough from it, along the line
};

/// A side to which a machine can turn one way only: from the heading at which it meets it to that along it.
struct OneWaySide {
  Point inwards;  ///< unit vector
  Point along;    ///< unit vector: the heading along the side to which it turns
  double angle;   ///< between the heading and `along`, rad, from 0 to π/2
  double back_m;  ///< along the line until it could turn the other way as well
};

/// Where a way leaves a line, or enters it.
struct LineExit {
  Pose pose;            ///< of the axle, as it works
  double backing = -1;  ///< along the heading: -1 out of an end, +1 into a beginning
  SteeredPath line{};   ///< from there as far as it turns by little and as the machine could
  double length_m = 0;  ///< of that
  double bent = 0;      ///< by how much it turns, as a sine
  std::vector<NearSide> near{};
  std::vector<OneWaySide> one_way{};
};

/// Lower bounds of the time of ways on land with straight sides, by a machine that turns forward only, and
/// backs along the lines it works.
///
/// On its way from one heading to another that points away from a side, a machine that heads for the side is
/// parallel to it at some place, by then at least r (1 − cos φ) nearer, φ being the angle between its heading
/// and the side. There half its outline lies between it and the side. Where that is not as far, it has to
/// back first; and where it is not r (1 + cos φ) nearer by then, it turns to the one heading along the side
/// only. If both ends of a way turn to the same, it has to drive a loop between. On a strip of land narrower
/// than its outline and twice its radius, no machine that drives along it turns to the opposite heading:
/// turning by half a circle takes it 2 r across. Nor does it come back to a place that it has passed.
class LeastBacking {
 public:
  /// `beyond_m`: how far beyond the field is land. Preconditions: nothing is towed on a drawbar, the machine
  /// does not turn in reverse, the ring has an area.
  LeastBacking(const Ring& outer, double beyond_m, const Machine& machine);

  /// For the axle's way over a work. O(sides). Precondition: it has a stretch.
  LineExit left(const SteeredPath& work) const;
  LineExit entered(const SteeredPath& work) const;

  /// From leaving one line to entering another, s; `known_s` or more: a lower bound without regard to the
  /// land. The distances backed are divided until the bound is found to kDivided_s or kDividedShare.
  double between(const LineExit& left, const LineExit& entered, double known_s) const;

 private:
  struct Side {
    Point at;
    Point inwards;
  };
  /// The narrowest band that the land lies in.
  struct Strip {
    Point along;
    double width_m = 0;
  };
  enum class Along { kFree, kSameWay, kOppositeWays };
  Along on_strip(const LineExit& left, const LineExit& entered) const;
  LineExit exit_of(const SteeredPath& line, double backing, double straight_on_m) const;
  enum class Turned { kLeast, kOtherWay };
  double lacks_m(const Side& side, const Pose& pose, double backing, Turned turned) const;
  double back_m(const Side& side, const LineExit& exit, Turned turned) const;
  /// Distances backed in a region, m: the least and the farthest, of both ends.
  struct Backed {
    double out_from = 0, out_to = 0, in_from = 0, in_to = 0;
    double in_all = 0;  ///< both together at least
    bool out = false, in = false;
  };
  double seconds(const Backed& all, double back_m, double forward_m) const;
  double forward_m(const LineExit& left, const LineExit& entered, const Backed& all, double out_m,
                   double in_m) const;
  double lacking_m(const LineExit& left, const LineExit& entered) const;
  static double less_s(double found_s);
  double least_of(const LineExit& left, const LineExit& entered, Backed all, double known_s) const;
  /// Distances to be backed, m: out, in, and both together.
  struct Asked {
    std::optional<double> out_m{}, in_m{};
    double in_all_m = 0;
  };
  double least_of_all(const LineExit& left, const LineExit& entered, const Asked& asked,
                      double known_s) const;
  double least_along(const LineExit& left, const LineExit& entered, Along along) const;
  double least_loop(const LineExit& left, const LineExit& entered, double known_s) const;
  double loop_m(const LineExit& left, const OneWaySide& leaves, const LineExit& entered,
                const OneWaySide& enters) const;
  double least_beyond(const LineExit& left, const LineExit& entered) const;

  Turning turning_;
  double radius_m_;
  double aside_m_;  ///< the outline reaches at least as far to either side
  double reach_m_;  ///< and no farther ahead or behind
  std::vector<Side> sides_;
  Strip strip_;
};

/// LeastBacking::between() may be less than the least time by so much, s, or by such a share of it: more than
/// the verifier's search may be.
inline constexpr double kDivided_s = 0.1, kDividedShare = 0.003;

}  // namespace tramline
