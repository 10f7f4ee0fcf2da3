#pragma once
// Where machines stop to back out of tracks or into them.

#include <vector>

#include "tramline/model/plan.h"

namespace tramline::render {

/// The end of a track or pass, and the unit vector along which the machine backs away from it or comes to it.
struct StopPlace {
  Point at;
  Point back;
};

/// Where the route backs out or in; without a route, at ends of tracks that no turn leads away from.
std::vector<StopPlace> stop_places(const Plan& plan);

}  // namespace tramline::render
