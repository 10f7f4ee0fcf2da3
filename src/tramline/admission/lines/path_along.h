#pragma once
// Whether a drawn line still runs along the path that it was exported from.

#include <optional>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// The path in the direction in which the line is drawn; nullopt where the line does not run along it, from
/// its one end to its other, within `within_m`: it was moved, cut or lengthened. Precondition: neither is
/// empty. O(n + m) for vertices that lie where the path does.
std::optional<Path> path_along(const Path& path, const std::vector<Point>& line, double within_m);

}  // namespace tramline
