#pragma once
// The lines along which the sweep cuts a polygon (S1.17).

#include <vector>

#include "tramline/decomposition/events.h"
#include "tramline/geometry/track_frame.h"

namespace tramline {

/// For every event the stretch of the line through its vertex, parallel to `direction`, that runs
/// from the vertex through the field's inside to the next boundary on either side. A side on which
/// the line leaves the field or follows an edge at once has no stretch.
/// The far ends overshoot the boundary by kCutOvershoot so that the noding finds the crossing.
/// O(events · n).
inline constexpr double kCutOvershoot = 1e-3;  // m
std::vector<std::vector<Point>> cut_lines(const Polygon& polygon, const std::vector<SplitEvent>& events,
                                          Direction direction);

}  // namespace tramline
