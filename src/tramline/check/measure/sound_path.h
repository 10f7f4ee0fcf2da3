#pragma once

#include <string>

#include "tramline/geometry/path/path.h"

namespace tramline::check {

/// Whether a point has plausible coordinates; false for NaN.
bool on_the_map(Point p);

/// The fault of a path in itself, or "": segments without length, off the map, arcs longer than half a
/// circle, or ends that do not meet. Whether it can be driven is another question.
std::string fault_of(const Path& path);

}  // namespace tramline::check
