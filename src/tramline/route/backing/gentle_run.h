#pragma once
// Stretches of lines along which a machine may back with about the same heading.

#include <optional>
#include <span>

#include "tramline/geometry/path/steered_path.h"

namespace tramline {

/// Part of a line that turns by no more than 30° from the heading with which it begins, without kinks and no
/// sharper than the machine turns.
struct GentleRun {
  SteeredPath line{};
  double bent = 0;      ///< by how much it turns, as a sine
  double begins_m = 0;  ///< so far along the line
  bool to_end = false;  ///< of the line
};

/// The run with which a line begins; empty where that is too sharp. O(n). Precondition: the line has a
/// stretch.
GentleRun first_run(std::span<const SteeredStretch> line, double radius_m);

/// The longest run that begins behind a bend, if it is longer than the first one by a metre, and the machine
/// can drive from there to the beginning of the line. O(n). Precondition: the line has a stretch.
std::optional<GentleRun> longest_run_behind_bends(const SteeredPath& line, double radius_m);

}  // namespace tramline
