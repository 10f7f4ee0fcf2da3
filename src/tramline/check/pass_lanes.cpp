#include "tramline/check/pass_lanes.h"

#include <cassert>

#include "tramline/check/bands.h"
#include "tramline/check/sound_path.h"

namespace tramline::check {
namespace {

/// The last metres before the end, seen along the heading there. No swath that lies flat turns by a right
/// angle on them.
Lane end_lane(const Path& path, double half_width_m) {
  const double part_m = 1.5 * half_width_m;
  const Path last = begun_later(path, std::max(0.0, length(path) - part_m));
  const Point end = last.back().to, along = direction_at_end(last.back());
  return {PieceFrame(end, end + along), last, half_width_m};
}

}  // namespace

std::vector<Lane> pass_lanes(const HeadlandPass& pass, double width_m) {
  assert(fault_of(pass.path).empty());
  const Path& path = pass.path;
  const double half_m = 0.5 * width_m;
  const auto as_a_whole = [&](const Path& part) {
    return Lane(PieceFrame(part.front().from, part.front().to), part, half_m);
  };
  if (is_closed(pass)) return {as_a_whole(path)};
  std::vector<Lane> out{end_lane(path, half_m), end_lane(reversed(path), half_m)};
  // What is left has ground of the pass all about its ends.
  if (const Path middle = shortened(path, half_m); !middle.empty()) out.push_back(as_a_whole(middle));
  return out;
}

}  // namespace tramline::check
