#pragma once
// How far the sides near to one end of a way make a machine back there.

#include <limits>
#include <optional>

#include "tramline/route/backing/line_exits.h"

namespace tramline {

/// Where there is no such place along a line.
inline constexpr double kNowhere_m = std::numeric_limits<double>::infinity();

/// To back in all, at both ends together, or at one end only, m.
struct HeadsAllAlong {
  double in_all_m = kNowhere_m, here_only_m = kNowhere_m, there_only_m = kNowhere_m;
};

/// What the sides ask of one end of a way.
struct NeededBacking {
  std::optional<double> back_m{};  ///< to back there so far at least; nullopt: nothing
  HeadsAllAlong or_all_along{};    ///< or so far, to head for a side all the way
};

/// What the sides near to the exit ask; `other` is the other end of the way. Where the way heads for a side
/// there too, it need not turn away from it, but then it cannot lead away from it. O(sides).
NeededBacking needed_backing(const LineExit& exit, const LineExit& other, double radius_m);

}  // namespace tramline
