#pragma once
// Steered paths as text, exact where a line of chords is not.

#include <string>

#include "tramline/geometry/path/steered_path.h"

namespace tramline::io {

/// "x y heading length k0 k1 gear; …" for each stretch: where it begins, the heading there (rad, clockwise
/// from north), its length in metres, the curvatures at its start and end (1/m, positive with the centre on
/// the machine's left), and `forward` or `reverse`. Numbers have as many digits as restore them to the bit.
/// `offset` is added to every point. "" for an empty path.
std::string steered_text(const SteeredPath& path, Point offset);

/// The inverse: `offset` is subtracted. Throws Error(kBadInput) that begins with `place` where the text is of
/// another form, or a stretch has a length below 0, above 100 km, or that turns farther than 100 rad. O(n).
SteeredPath steered_from_text(const std::string& text, Point offset, const std::string& place);

}  // namespace tramline::io
