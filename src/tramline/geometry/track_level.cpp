#include "tramline/geometry/track_level.h"

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

constexpr double kSamePlace = 1e-6;

/// Bends whose parallel is tighter than the machine can follow.
Intervals tight_bends(const Contour& contour, double distance, double least_radius) {
  Intervals out;
  for (const ContourElement& e : contour.elements) {
    if (e.straight || e.cap) continue;
    const bool gone = !reaches(e, distance);
    if (gone || std::abs(e.reach + distance) < least_radius * (1 - 1e-9))
      append_joining(out, {e.start, e.start + e.length});
  }
  return out;
}

/// The stretch in which a place lies; the wide places lie in stretches but for rounding.
std::size_t stretch_at(const Intervals& stretches, double place) {
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (place >= stretches[i].from - kSamePlace && place <= stretches[i].to + kSamePlace) return i;
  return stretches.size();
}

class Joiner {
 public:
  Joiner(TrackLevel& level, const std::vector<FrontCorner>& corners, double sharpest)
      : level_(level), corners_(corners), sharpest_(sharpest) {}

  void run() {
    const std::size_t n = level_.stretches.size();
    for (const FrontCorner& corner : corners_) {
      const std::size_t before = stretch_at(level_.stretches, corner.before);
      const std::size_t after = stretch_at(level_.stretches, corner.after);
      if (before == n || after == n || corner.turn_rad > sharpest_) continue;
      // A stretch that is wide again further on passes a narrow place: it is not left before that.
      if (!last_wide(before, corner.before) || !first_wide(after, corner.after)) continue;
      if (before == after && corner.after > corner.before) continue;
      const auto taken = [&](const TrackJoin& join) { return join.before == before || join.after == after; };
      if (std::any_of(level_.joins.begin(), level_.joins.end(), taken)) continue;
      level_.joins.push_back({before, after, corner});
    }
    for (const TrackJoin& join : level_.joins) {
      const Interval &before = level_.stretches[join.before], &after = level_.stretches[join.after];
      if (before.to > join.corner.before) level_.lost.push_back({join.corner.before, before.to});
      if (join.corner.after > after.from) level_.lost.push_back({after.from, join.corner.after});
    }
    std::sort(level_.lost.begin(), level_.lost.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
  }

 private:
  bool last_wide(std::size_t stretch, double place) const {
    return std::none_of(level_.wide.begin(), level_.wide.end(), [&](const Interval& wide) {
      return wide.from > place && wide.from < level_.stretches[stretch].to - kSamePlace;
    });
  }
  bool first_wide(std::size_t stretch, double place) const {
    return std::none_of(level_.wide.begin(), level_.wide.end(), [&](const Interval& wide) {
      return wide.to < place && wide.to > level_.stretches[stretch].from + kSamePlace;
    });
  }

  TrackLevel& level_;
  const std::vector<FrontCorner>& corners_;
  double sharpest_;
};

}  // namespace

TrackLevel track_level(const Contour& contour, double distance_m, const TrackLimits& limits, Sides sides) {
  const double least_radius = limits.least_radius_m(), half_width = 0.5 * limits.width_m;
  Front far = front_at(contour, distance_m + least_radius, sides);
  TrackLevel out;
  out.distance_m = distance_m;
  out.wide = std::move(far.feet);
  const Intervals swath =
      least_radius > half_width ? front_at(contour, distance_m + half_width, sides).feet : out.wide;
  out.stretches = without(swath, tight_bends(contour, distance_m, least_radius));
  std::erase_if(out.stretches, [](const Interval& stretch) { return stretch.length() < kSamePlace; });
  Joiner(out, far.corners, limits.sharpest_corner.radians()).run();
  return out;
}

}  // namespace tramline
