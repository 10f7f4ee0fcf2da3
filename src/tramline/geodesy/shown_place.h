#pragma once
// Places in a field as text.

#include <string>

#include "tramline/geometry/point.h"
#include "tramline/model/local_frame.h"

namespace tramline {

/// "(11.2345678, 48.1234567)": a point in local metres as longitude and latitude or, in a plain frame, in the
/// metres of the input with 2 decimals. Throws failure far outside the frame.
std::string shown_place(const LocalFrame& frame, Point local_m);

}  // namespace tramline
