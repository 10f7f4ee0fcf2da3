#pragma once
// The exact path of a line in an export, whose shape is chords.

#include <optional>
#include <string>

#include "tramline/geometry/path/path.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// The column that holds it.
inline constexpr const char* kExactPath = "exact_path";

struct ExactPath {
  LocalFrame frame;     ///< in which the path is; plain: the plane of the file, or a shift of it
  double within_m = 0;  ///< the farthest that the exported shape may lie from the path
  Path path;
};

/// "tmerc 13.2541 53.5562 within 0.02: x y; x y k": the origin of the field's transverse Mercator, then the
/// text of the path as in a plan file (path_text()), exact to the last bit. "metres within 0.02: x y; x y k"
/// in plain metres, there in the plane of the file.
std::string exact_path_text(const LocalFrame& frame, double within_m, const std::string& path_text);

/// The inverse; nullopt for any other text, such as one that a program has cut. O(n).
std::optional<ExactPath> exact_path_from_text(const std::string& text);

}  // namespace tramline::io
