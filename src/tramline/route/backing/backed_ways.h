#pragma once
// The least that ways take which back out of a line or into another by some distances.

#include <optional>
#include <vector>

#include "tramline/model/machine.h"
#include "tramline/route/backing/line_exits.h"

namespace tramline {

/// Where the axle is when it has backed so far along the line, m.
Pose backed(const LineExit& exit, double by_m);

/// What ways take.
struct BackingTerms {
  Turning turning;
  double stop_s = 0;    ///< to back, with the changes of gear before and after
  double radius_m = 0;  ///< more than 0
};

/// Distances to be backed at least, m: out, in, and both together; and out or in where it backs only there.
/// None out or in: it need not back there.
struct AskedBacking {
  std::optional<double> out_m{}, in_m{};
  double in_all_m = 0;
  double only_out_m = 0, only_in_m = 0;
  int least_stops = 0;  ///< a way with fewer does not get there
};

/// Ways from leaving one line to entering another that back no farther than these are followed. Those that
/// back along a line behind a bend have backed round the bend before; all others do not drive it.
class BackedWays {
 public:
  /// All outlive the ways.
  BackedWays(const BackingTerms& terms, const LineExit& left, const LineExit& entered);

  /// Whether they turn to the same heading along a side at both ends, and so have to drive a loop between.
  bool loop() const { return !loops_.empty(); }

  /// No way that backs so far as asked takes less, s; `known_s` where none of them takes less than that. The
  /// distances backed are divided until the bound is found to kDivided_s or kDividedShare.
  double least_s(const AskedBacking& asked, double known_s) const;

 private:
  /// A side along which both ends turn to the same heading.
  struct Loop {
    OneWaySide leaves, enters;
  };
  /// Distances backed in a region, m: the least and the farthest, of both ends.
  struct Backed {
    double out_from = 0, out_to = 0, in_from = 0, in_to = 0;
    double in_all = 0;  ///< both together at least
    bool out = false, in = false;
    int least_stops = 0;
  };
  double loop_m(const Loop& loop, const Pose& from, const Pose& to) const;
  double forward_m(const Backed& backed_by) const;
  bool behind_bends() const { return left_.behind_m > 0 || entered_.behind_m > 0; }
  double seconds(const Backed& all, double back_m, double forward_m) const;
  double bend_s(const LineExit& exit, bool backs) const;
  std::vector<Backed> parted(const Backed& all) const;
  double least_of(Backed all, double known_s) const;

  const BackingTerms& terms_;
  const LineExit& left_;
  const LineExit& entered_;
  std::vector<Loop> loops_;
};

/// BackedWays::least_s() may be less than the least time by so much, s, or by such a share of it: more than
/// the verifier's search may be.
inline constexpr double kDivided_s = 0.1, kDividedShare = 0.003;
/// That much.
double less_by_dividing_s(double found_s);
/// Distances backed are divided down to so much, m.
inline constexpr double kLeastDivided_m = 0.05;

}  // namespace tramline
