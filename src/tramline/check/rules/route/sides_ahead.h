#pragma once
// What the sides ahead of one end of a way ask of it: facts of the rule about the bound of a route.

#include <optional>

#include "tramline/check/rules/route/way_ends.h"

namespace tramline::check {

/// Distances backed at both ends together, at this end alone, or at the other alone, m.
struct Instead {
  double together_m = kNever_s, here_m = kNever_s, there_m = kNever_s;
};

/// How far a way has to back at one end, m; nullopt: not at all.
struct Asked {
  std::optional<double> back_m{};
  Instead instead{};  ///< or so, and never parallel to some side
};

/// Ways that head for a side where they end as well may never turn away from it, if they end nearer to it.
Asked asked(const WayEnd& end, const WayEnd& other, double radius_m);

}  // namespace tramline::check
