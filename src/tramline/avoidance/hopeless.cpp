#include "tramline/avoidance/hopeless.h"

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

/// Length of the path's parts that may still be over the strip itself.
double length_near_strip(const Path& path, double centre, double width_m) {
  double sum = 0;
  for (const PathSegment& segment : path) {
    const double off = std::min(std::abs(segment.from.x - centre), std::abs(segment.to.x - centre));
    if (off < width_m) sum += length(segment);
  }
  return sum;
}

double area_of(const StripProfile& profile, const Intervals& parts) {
  double sum = 0;
  for (const Interval& part : parts) sum += area_between(profile, part.from, part.to);
  return sum;
}

/// Ground of a subfield's strips in the window (in the plane of its grid) that they do not work straight.
double free_m2(const Strips& strips, std::size_t subfield, const WorkedGround& ground, const Box& window,
               const Strip* except) {
  double sum = 0;
  const double width = strips.grid.width_m;
  const int first = strips.strips.empty() ? 0 : strips.strips.front().index;
  const auto place = [&](double across) {
    return std::floor((across - strips.grid.origin_m) / width) - first;
  };
  const double count = static_cast<double>(strips.strips.size());
  const auto from = static_cast<std::size_t>(std::clamp(place(window.min_x), 0.0, count));
  const auto to = static_cast<std::size_t>(std::clamp(place(window.max_x) + 1, 0.0, count));
  for (std::size_t i = from; i < to; ++i) {
    const Strip& strip = strips.strips[i];
    if (&strip == except) continue;
    const Intervals worked = ground.at(subfield, strip.index).straight;
    sum += area_of(strip.subfield, without({{window.min_y, window.max_y}}, worked));
  }
  return sum;
}

double length_of(const Intervals& parts) {
  double sum = 0;
  for (const Interval& part : parts) sum += part.length();
  return sum;
}

/// What joining the pieces at the option's gaps can save at most.
double saved_at_most(const TrackOption& option, const Objective& objective) {
  const double gaps = static_cast<double>(option.way.last_gap - option.way.first_gap + 1);
  return gaps * (objective.turn + 2 * objective.stop);
}

/// Boxes round all ground the detour works, none much longer than a swath is wide.
std::vector<Box> boxes_along(const Path& path, double width_m) {
  Path steps;
  for (const PathSegment& segment : path) {
    const int count = segment.straight() ? 1 + static_cast<int>(length(segment) / (2 * width_m)) : 1;
    if (count == 1) {
      steps.push_back(segment);
      continue;
    }
    const Point step = (1.0 / count) * (segment.to - segment.from);
    for (int i = 0; i < count; ++i)
      steps.push_back({segment.from + i * step, segment.from + (i + 1) * step, 0});
  }
  return reaches_of(steps, width_m);
}

Box turned_box(const Box& window, const TrackFrame& from, const TrackFrame& to) {
  Box out;
  for (const double x : {window.min_x, window.max_x})
    for (const double y : {window.min_y, window.max_y}) out.extend(to.to_track(from.to_field({x, y})));
  return out;
}

}  // namespace

bool hopeless(const TrackOption& option, std::size_t subfield, const Strip& strip,
              const std::vector<Strips>& strips, const WorkedGround& ground, const Objective& objective) {
  const StripGrid& grid = strips[subfield].grid;
  const StripDetour& detour = option.way.detour;
  const Intervals replaced = common(strip.stretches, {option.straight});
  const double replaced_m2 = area_of(strip.subfield, replaced);
  const double longer = grid.width_m * (detour.length_m - length_of(replaced));

  double useful_m2 = grid.width_m * length_near_strip(detour.path, grid.centre(strip.index), grid.width_m);
  const double saved = saved_at_most(option, objective);
  const auto pays = [&] {
    const double gain = std::min(useful_m2, grid.width_m * detour.length_m) - replaced_m2;
    return objective.overlap * longer - (objective.overlap + objective.uncovered) * gain < saved;
  };
  if (pays()) return false;
  for (const Box& box : boxes_along(detour.path, grid.width_m)) {
    for (std::size_t i = 0; i < strips.size(); ++i)
      useful_m2 += free_m2(strips[i], i, ground, turned_box(box, grid.frame, strips[i].grid.frame), &strip);
    if (pays()) return false;
  }
  return true;
}

bool far_too_dear(const TrackOption& option, const Strip& strip, double width_m, const Objective& objective) {
  const double longer =
      width_m * (option.way.detour.length_m - length_of(common(strip.stretches, {option.straight})));
  const double areas =
      objective.overlap * longer - (objective.overlap + objective.uncovered) * option.gain_m2();
  return areas > 2 * saved_at_most(option, objective);
}

}  // namespace tramline
