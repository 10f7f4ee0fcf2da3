#include "tramline/route/build/lines_through_narrows.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "tramline/geometry/interval.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/route/order/point_grid.h"

namespace tramline {
namespace {

/// Lines are looked at in places so far apart at most, m.
constexpr double kStep_m = 1;

struct Place {
  double along_m = 0;
  Point at;
};

std::vector<Place> places_on(const SteeredPath& path) {
  std::vector<Place> out;
  double before_m = 0;
  for (const SteeredStretch& stretch : path) {
    const double steps = std::ceil(stretch.length_m / kStep_m);
    for (double i = 0; i < steps; ++i) {
      const double after_m = stretch.length_m * i / steps;
      out.push_back({before_m + after_m, pose_after(stretch, after_m).at});
    }
    before_m += stretch.length_m;
  }
  out.push_back({before_m, end_of(path).at});
  return out;
}

std::vector<Point> places_on(const std::vector<FollowedLine>& lines) {
  std::vector<Point> out;
  for (const FollowedLine& line : lines)
    if (!line.track)
      for (const Place& place : places_on(line.axle)) out.push_back(place.at);
  return out;
}

/// Stretches of a line of which all places are so far off.
Intervals stretches_off(const FollowedLine& line, const order::PointGrid& places, double off_m) {
  Intervals out;
  bool off = false;
  for (const Place& place : places_on(line.axle)) {
    const bool was_off = std::exchange(off, !places.has_within(place.at, off_m));
    if (off && !was_off) out.push_back({place.along_m, place.along_m});
    if (off) out.back().to = place.along_m;
  }
  return out;
}

/// A closed line begins anywhere: a stretch at its beginning goes on where one at its end ends.
std::vector<SteeredPath> parts_of(const FollowedLine& line, const Intervals& stretches) {
  std::vector<SteeredPath> out;
  for (const Interval& stretch : stretches) out.push_back(part_of(line.axle, stretch.from, stretch.to));
  const bool meet = line.closed && stretches.size() > 1 && stretches.front().from == 0 &&
                    stretches.back().to == length(line.axle);
  if (!meet) return out;
  out.back().insert(out.back().end(), out.front().begin(), out.front().end());
  out.erase(out.begin());
  return out;
}

}  // namespace

std::vector<FollowedLine> lines_through_narrows(const std::vector<FollowedLine>& round_boundaries,
                                                const std::vector<FollowedLine>& followed,
                                                const DrivingGround& ground) {
  const std::vector<Point> places = places_on(followed);
  if (places.empty()) return round_boundaries;
  const order::PointGrid grid(places);
  const double off_m = half_breadth_m(ground.outline()) + kBesideLines_m;
  std::vector<FollowedLine> out;
  for (const FollowedLine& line : round_boundaries) {
    const Intervals stretches = stretches_off(line, grid, off_m);
    const bool whole = stretches.size() == 1 && stretches.front().length() == length(line.axle);
    if (whole) {
      out.push_back(line);
      continue;
    }
    for (SteeredPath& part : parts_of(line, stretches))
      if (length(part) >= kShortestNarrows_m) out.push_back({std::move(part), false, false});
  }
  return out;
}

}  // namespace tramline
