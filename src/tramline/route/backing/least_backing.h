#pragma once
// How far a machine has to back where the sides of the field leave it no way forward.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/machine.h"
#include "tramline/route/backing/backed_first.h"
#include "tramline/route/backing/backed_ways.h"
#include "tramline/route/backing/gentle_run.h"
#include "tramline/route/backing/heading_reach.h"
#include "tramline/route/backing/line_exits.h"

namespace tramline {

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
/// Where it has backed all along a line and on, it is aslant to the side behind it as long as that leaves it
/// no room to come parallel: so it does not get far along that side before it stops, nor forward to where
/// another line begins too near to a side that it heads for. Then it has to stop to back once more.
/// Of few lines it is followed to all places and headings that it gets to without a stop (HeadingReach),
/// which tells whether a way has to back at all, and along which of the two lines, and whether one to a
/// closed pass has to. Each stop to back counts `stop_s` besides its time. Not for several
/// threads.
class LeastBacking {
 public:
  /// Whether the places that the machine gets to are followed: milliseconds for each end of a line.
  enum class Places { kNotFollowed, kFollowed };

  /// `beyond_m`: how far beyond the field is land. Preconditions: nothing is towed on a drawbar, the machine
  /// does not turn in reverse, the ring has an area.
  LeastBacking(const Ring& outer, double beyond_m, const Machine& machine, double stop_s = 0,
               Places places = Places::kNotFollowed);

  /// For the axle's way over a work. O(sides). Precondition: it has a stretch.
  LineExits left(const SteeredPath& work) const;
  LineExits entered(const SteeredPath& work) const;

  /// From leaving one line to entering another, s; `known_s` or more: a lower bound without regard to the
  /// land. The distances backed are divided until the bound is found to kDivided_s or kDividedShare.
  double between(const LineExits& left, const LineExits& entered, double known_s) const;

  /// Between an end of a line, left or entered, and a closed pass that the axle works along one of these
  /// lines, s; at least `known_s`. `on_s`: what it takes at least on to the pass from a pose of the line, or
  /// from the pass to there.
  double to_ring(const LineExits& exits, std::span<const SteeredPath> ring, const LeastOnFrom& on_s,
                 double known_s) const;

 private:
  using Side = HeadingReach::Side;
  /// The narrowest band that the land lies in.
  struct Strip {
    Point along;
    double width_m = 0;
  };
  enum class Along { kFree, kSameWay, kOppositeWays };
  Along on_strip(const LineExit& left, const LineExit& entered) const;
  std::shared_ptr<const PlacesByHeading> places_from(const Pose& pose, double sense) const;
  LineExits exits_of(const SteeredPath& line, double backing, double straight_on_m) const;
  LineExit exit_of(GentleRun run, const Pose& pose, double backing, double straight_on_m) const;
  enum class Turned { kLeast, kOtherWay };
  double lacks_m(const Side& side, const Pose& pose, double backing, Turned turned) const;
  double back_m(const Side& side, const LineExit& exit, Turned turned) const;
  double lacking_m(const LineExit& left, const LineExit& entered) const;
  /// How a machine moves on towards a side.
  struct Aslant {
    double flattest = 0;  ///< angle to the side, rad; 0 where it may come parallel to it
    double aside_m = 0;   ///< how far along the side it gets at the most; infinite then
  };
  Aslant aslant(const Side& side, const Pose& pose, double sense) const;
  bool one_stop_may_do(const LineExit& exit, const LineExit& other) const;
  /// Whether a way may do with one stop: to back along the line that it leaves or the one that it enters, or
  /// all along that and on.
  struct OneStop {
    bool out = true, in = true;
    bool out_and_on = true, in_and_on = true;
    int least_stops = 0;  ///< none where it need not back along either, two where one never does
    bool all() const { return least_stops == 0 && out_and_on && in_and_on; }
  };
  static OneStop one_stop(const LineExits& left, const LineExits& entered);
  double least_along(const BackedWays& ways, const LineExit& left, const LineExit& entered, Along along,
                     const OneStop& may) const;
  double least_beyond(const LineExit& left, const LineExit& entered, const OneStop& may) const;
  double least_of_lines(const LineExits& left, const LineExits& entered, const OneStop& may,
                        double known_s) const;
  double least_behind_bends(const LineExits& left, const LineExits& entered, int least_stops,
                            double known_s) const;
  double least_between(const LineExit& left, const LineExit& entered, const OneStop& may,
                       double known_s) const;

  BackingTerms terms_;
  double aside_m_;   ///< the outline reaches at least as far to either side
  double behind_m_;  ///< with corners there so far behind the axle
  double ahead_m_;   ///< and so far ahead
  double reach_m_;   ///< and no farther ahead or behind
  std::vector<Side> sides_;
  Strip strip_;
  std::optional<HeadingReach> reach_{};  ///< where places are followed
  struct Followed {
    Pose from;
    double sense;
    std::shared_ptr<const PlacesByHeading> places;
  };
  mutable std::vector<Followed> followed_{};
};

}  // namespace tramline
