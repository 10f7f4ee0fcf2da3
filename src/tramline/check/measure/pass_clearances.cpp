#include "tramline/check/measure/pass_clearances.h"

#include <cassert>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/sound_path.h"

namespace tramline::check {
namespace {

/// The last metres before the end, seen along the heading there. No swath that lies flat turns by a right
/// angle on them.
SwathClearance end_lane(const Path& path, double half_width_m) {
  const double part_m = 1.5 * half_width_m;
  const Path last = begun_later(path, std::max(0.0, length(path) - part_m));
  const Point end = last.back().to, along = direction_at_end(last.back());
  return {PieceFrame(end, end + along), last, half_width_m};
}

}  // namespace

std::vector<SwathClearance> pass_clearances(const HeadlandPass& pass, double width_m) {
  assert(fault_of(pass.path).empty());
  const Path& path = pass.path;
  const double half_m = 0.5 * width_m;
  const auto as_a_whole = [&](const Path& part) {
    return SwathClearance(PieceFrame(part.front().from, part.front().to), part, half_m);
  };
  if (is_closed(pass)) return {as_a_whole(path)};
  std::vector<SwathClearance> out{end_lane(path, half_m), end_lane(reversed(path), half_m)};
  // What is left has ground of the pass all about its ends.
  if (const Path middle = shortened(path, half_m); !middle.empty()) out.push_back(as_a_whole(middle));
  return out;
}

}  // namespace tramline::check
