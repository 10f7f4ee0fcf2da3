#include "tramline/route/connection/roadmap.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/route/axle/axle_path.h"

namespace tramline {
namespace {

/// The path in `parts` parts of equal length. O(n + parts).
std::vector<SteeredPath> divided(const SteeredPath& path, std::size_t parts) {
  std::vector<SteeredPath> out(parts);
  const double each_m = length(path) / static_cast<double>(parts);
  std::size_t part = 0;
  double left_m = each_m;
  for (const SteeredStretch& whole : path) {
    double from_m = 0;
    while (from_m < whole.length_m) {
      const bool last = part + 1 == parts;
      const double take_m = last ? whole.length_m - from_m : std::min(left_m, whole.length_m - from_m);
      for (const SteeredStretch& stretch : part_of({whole}, from_m, from_m + take_m))
        out[part].push_back(stretch);
      from_m += take_m;
      left_m -= take_m;
      if (left_m > 0 || last) continue;
      ++part;
      left_m = each_m;
    }
  }
  return out;
}

}  // namespace

Roadmap::Roadmap(const std::vector<FollowedLine>& lines, double spacing_m) {
  assert(spacing_m > 0);
  std::size_t number = 0;
  for (const FollowedLine& line : lines) {
    add(line, line.axle, number++, spacing_m);
    add(line, turned_round(line.axle), number++, spacing_m);
  }
  std::vector<Box> boxes;
  boxes.reserve(poses_.size());
  for (const RoadmapPose& pose : poses_) {
    const Point at = pose.pose.at;
    boxes.push_back({at.x, at.y, at.x, at.y});
  }
  grid_ = BoxGrid(boxes);
}

void Roadmap::add(const FollowedLine& line, const SteeredPath& axle, std::size_t number, double spacing_m) {
  const double steps = line.track ? 1 : std::max(1.0, std::ceil(length(axle) / spacing_m));
  const std::size_t first = poses_.size();
  for (SteeredPath& part : divided(axle, static_cast<std::size_t>(steps))) {
    if (part.empty()) continue;
    const Pose start = part.front().start;
    poses_.push_back({start, start.heading.unit(), number, poses_.size() + 1, std::move(part), line.track});
  }
  if (line.closed) {
    poses_.back().next = first;
    return;
  }
  const Pose end = end_of(axle);
  poses_.push_back({end, end.heading.unit(), number, {}, {}, line.track});
}

}  // namespace tramline
