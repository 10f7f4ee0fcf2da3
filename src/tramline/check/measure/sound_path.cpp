#include "tramline/check/measure/sound_path.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The fault of a segment in itself, or "".
std::string fault_in(const PathSegment& segment) {
  if (!on_the_map(segment.from) || !on_the_map(segment.to)) return "lies off the map";
  const double chord = distance(segment.from, segment.to);
  if (chord <= kShortest_m) return "has no length";
  if (segment.straight()) return "";
  // Rounding may make the chord of an exact half circle longer by the last digits of its ends.
  constexpr double kDigits_m = 4e-9;
  if (!(radius(segment) <= kFarthest_m)) return "is an arc of a circle larger than the map";
  if (!(chord <= 2 * radius(segment) * (1 + kRounding) + kDigits_m)) return "is longer than half a circle";
  return "";
}

}  // namespace

bool on_the_map(Point p) { return std::abs(p.x) <= kFarthest_m && std::abs(p.y) <= kFarthest_m; }

std::string fault_of(const Path& path) {
  if (path.empty()) return "has no path";
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::string segment = fmt::format("segment {} ", i + 1);
    if (const std::string fault = fault_in(path[i]); !fault.empty()) return segment + fault;
    if (i > 0 && distance(path[i - 1].to, path[i].from) > kJoint_m)
      return segment + "does not begin where the one before ends";
  }
  return "";
}

}  // namespace tramline::check
