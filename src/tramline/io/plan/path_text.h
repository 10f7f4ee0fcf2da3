#pragma once
// Paths as text, exact where a line of chords is not.

#include <string>
#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline::io {

/// "x y; x y k; x y k": where the path starts, then for each segment the point it leads to and its
/// curvature, 1/m, positive turning left and 0 straight. Numbers have as many digits as are needed to restore
/// them bit-identically; 0 has no sign. `offset` is added to every point. Precondition: the path is not
/// empty; only the first segment's beginning is written.
std::string path_text(const Path& path, Point offset);

/// The inverse: `offset` is subtracted. Throws Error(kBadInput) that begins with `place` where the text is
/// malformed, a number is not finite or an arc is longer than half a circle. O(n).
Path path_from_text(const std::string& text, Point offset, const std::string& place);

/// The text of a path that may be empty: "" then.
std::string path_text_if_any(const Path& path, Point offset);
Path path_from_text_if_any(const std::string& text, Point offset, const std::string& place);

/// "x y; x y": points of a line, "" for none; digits and `offset` as in paths. O(n).
std::string points_text(const std::vector<Point>& points, Point offset);
/// The inverse. Throws Error(kBadInput) that begins with `place` where the text is of another form.
std::vector<Point> points_from_text(const std::string& text, Point offset, const std::string& place);

}  // namespace tramline::io
