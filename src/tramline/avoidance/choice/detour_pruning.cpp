#include "tramline/avoidance/choice/detour_pruning.h"

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

/// A detour may cost this many times as much as its cuts before it is dropped: other tracks that bend away
/// leave land to it that it does not find while they are cut.
constexpr double kDoubt = 3;

/// Length of the path's parts that may still be over the strip itself.
double length_near_strip(const Path& path, double centre, double width_m) {
  double sum = 0;
  for (const PathSegment& segment : path) {
    const double off = std::min(std::abs(segment.from.x - centre), std::abs(segment.to.x - centre));
    if (off < width_m) sum += length(segment);
  }
  return sum;
}

double area_of(const TrackProfile& profile, const Intervals& parts) {
  double sum = 0;
  for (const Interval& part : parts) sum += profile.area_between(part.from, part.to);
  return sum;
}

/// Area of a subfield's strips in the window (in the plane of its grid) that they do not work straight.
double free_m2(const TrackFamily& family, std::size_t family_index, const WorkedGround& ground,
               const Box& window, const Track* except) {
  double sum = 0;
  const double width = family.grid.width_m;
  const int first = family.tracks.empty() ? 0 : family.tracks.front().index;
  const auto index_at = [&](double across) {
    return std::floor((across - family.grid.origin_m) / width) - first;
  };
  const auto count = static_cast<double>(family.tracks.size());
  const auto from = static_cast<std::size_t>(std::clamp(index_at(window.min_x), 0.0, count));
  const auto to = static_cast<std::size_t>(std::clamp(index_at(window.max_x) + 1, 0.0, count));
  for (std::size_t i = from; i < to; ++i) {
    const Track& strip = family.tracks[i];
    if (&strip == except) continue;
    const Intervals worked = ground.at(family_index, i).on_track;
    sum += area_of(strip.subfield, without({{window.min_y, window.max_y}}, worked));
  }
  return sum;
}

double length_of(const Intervals& parts) {
  double sum = 0;
  for (const Interval& part : parts) sum += part.length();
  return sum;
}

/// Largest saving by joining the pieces at the option's gaps: turns, stops, and short stretches that would be
/// dropped between cuts.
double saved_at_most(const TrackOption& option, const TrackTerms& terms) {
  const Objective& prices = terms.objective;
  const auto gaps = static_cast<double>(option.way.last_gap - option.way.first_gap + 1);
  double sum = gaps * (prices.turn + 2 * prices.stop);
  for (std::size_t i = option.way.first_gap - 1; i <= option.way.last_gap; ++i) {
    const double length_m = terms.track.stretches[i].length();
    if (length_m < terms.min_length_m) sum += (prices.overlap + prices.uncovered) * terms.width_m * length_m;
  }
  return sum;
}

/// Boxes round all land the detour works, none much longer than a swath is wide.
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

bool can_be_pruned(const TrackOption& option, const TrackTerms& terms,
                   const std::vector<TrackFamily>& families, const WorkedGround& ground) {
  const Track& strip = terms.track;
  if (!is_straight(strip)) return false;
  const Objective& prices = terms.objective;
  const StripGrid& grid = families[terms.family].grid;
  const TrackDetour& detour = option.way.detour;
  const Intervals replaced = common(strip.stretches, {option.replaced});
  const double replaced_m2 = area_of(strip.subfield, replaced);
  const double longer = terms.width_m * (detour.length_m - length_of(replaced));

  double useful_m2 = terms.width_m * length_near_strip(detour.path, grid.centre(strip.index), terms.width_m);
  const double saved = saved_at_most(option, terms);
  const auto pays = [&] {
    const double gain = std::min(useful_m2, terms.width_m * detour.length_m) - replaced_m2;
    return prices.overlap * longer - (prices.overlap + prices.uncovered) * gain < kDoubt * saved;
  };
  if (pays()) return false;
  for (const Box& box : boxes_along(detour.path, terms.width_m)) {
    for (std::size_t i = 0; i < families.size(); ++i)
      useful_m2 +=
          free_m2(families[i], i, ground, turned_box(box, grid.frame, families[i].grid.frame), &strip);
    if (pays()) return false;
  }
  return true;
}

bool far_too_expensive(const TrackOption& option, const TrackTerms& terms) {
  const Objective& prices = terms.objective;
  const double replaced_m = length_of(common(terms.track.stretches, {option.replaced}));
  const double areas = prices.overlap * terms.width_m * (option.way.detour.length_m - replaced_m) -
                       (prices.overlap + prices.uncovered) * option.gain_m2();
  return areas > kDoubt * saved_at_most(option, terms);
}

}  // namespace tramline
