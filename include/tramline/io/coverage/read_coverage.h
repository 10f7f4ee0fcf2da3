#pragma once

#include <filesystem>

#include "tramline/model/coverage.h"

namespace tramline::io {

/// Reads a coverage file written by write_coverage. Coordinates and numbers are restored bit-identically (in
/// a plain frame, which is shifted: to 1e-9 m), polygons in the order of the file. Throws Error(kBadInput)
/// naming the file, and the layer, feature and column at fault, where the file is missing, truncated, not a
/// coverage file, or holds a number that is not finite. O(n).
Coverage read_coverage(const std::filesystem::path& path);

/// Whether a file is a GeoPackage with the layers of a coverage file; false where it cannot be opened.
bool is_coverage_file(const std::filesystem::path& path);

}  // namespace tramline::io
