#pragma once
// The least that ways take which back out of a line or into another: facts of the rule about the bound of a
// route.

#include <functional>
#include <optional>
#include <vector>

#include "tramline/check/rules/route/way_ends.h"
#include "tramline/model/machine.h"

namespace tramline::check {

/// What ways take.
struct WayCosts {
  Turning turning;
  double stop_s = 0;  ///< to back: what it counts, and two changes of gear
  double radius_m = 0;
};

/// Where both ends of a way come parallel to a side with the same heading u: it begins by turning to u and
/// ends by turning from −u, with half a turn between on the one or on the other side.
struct TurnedRound {
  SideBeside from, to;
};

/// Ways of which both ends are parallel make half a turn, which shortest paths know of: none of these.
std::vector<TurnedRound> turned_round(const WayEnd& from, const WayEnd& to);

/// Ways that back so far out of the one line and into the other at least, and so far together, or so far
/// where they back at one end alone, m; nullopt: as far as they like. `stops`: so many at least.
struct BackedAsAsked {
  std::optional<double> out_m{}, in_m{};
  double together_m = 0;
  double out_alone_m = 0, in_alone_m = 0;
  int stops = 0;
};

/// No way takes less, s, that backs by any distance along the line and then, with a stop, takes `on_s` at
/// least from there: no more from farther back than by driving on along the line. Found to a thousandth.
double least_backed_first_s(const WayCosts& costs, const WayEnd& end,
                            const std::function<double(const Pose&)>& on_s);

/// No way of any of these that backs no farther than the lines are followed takes less, s. Found to a
/// thousandth by splitting the distances backed, the most promising first; where it is `known_s` or more, to
/// that.
double least_backed_s(const WayCosts& costs, const WayEnd& from, const WayEnd& to,
                      const std::vector<BackedAsAsked>& ways, double known_s);

}  // namespace tramline::check
