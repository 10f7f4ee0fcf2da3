#pragma once
// The notable plans of a front.

#include "tramline/model/front.h"

namespace tramline {

/// The index of the point that costs least; the first of equals. Precondition: the front has points.
std::size_t cheapest_for(const Front& front, const Objective& prices);

/// The balanced plan. Overlap, uncovered land, and turns and stops together are each scaled so that the least
/// on the front is 0 and the most is 1 (where all are equal: 0). The knee is the point farthest from the
/// plane through the three extremes, on the side of (0, 0, 0): beyond it a loss in one number no longer gains
/// much in the others. Where the extremes span no plane that separates (0, 0, 0) from (1, 1, 1) with a normal
/// of positive components, it is the point nearest to (0, 0, 0). The first of equals. Precondition: the front
/// has points, and the marks of its extremes are set.
std::size_t knee_of(const Front& front);

/// All marks of a front with points, costs and prices. Precondition: the front has points.
FrontMarks marks_for(const Front& front);

/// The indices of the marked points and of others that are far enough apart, ascending. A point that differs
/// by less than `step` from one already shown in each of overlap, uncovered land, and turns plus stops is
/// omitted; the three are scaled as for the knee.
std::vector<std::size_t> points_to_show(const Front& front, double step);

}  // namespace tramline
