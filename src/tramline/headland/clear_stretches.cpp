#include "tramline/headland/clear_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/path_stretch.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// A path, and the test of which of its parts are clear of the offset boundaries.
class Clearance {
 public:
  Clearance(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries)
      : path_(path), boundaries_(offset_boundaries) {}

  bool is_clear(double from_m, double to_m) const {
    const Path part = stretch_of(path_, from_m, to_m);
    if (part.empty()) return true;
    return keeps_off(part, boundaries_) &&
           std::all_of(boundaries_.begin(), boundaries_.end(), [&](const OffsetBoundary& offset_boundary) {
             return contains(offset_boundary.ring, part.front().from) ==
                    (signed_area(offset_boundary.ring) > 0);
           });
  }
  /// The last clear position between one from or up to which it is clear and one where it is not.
  double end_of_clear(double clear_m, double other_m) const {
    constexpr int kHalvings = 24;
    double good_m = clear_m;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle_m = 0.5 * (good_m + other_m);
      const auto [from_m, to_m] = std::minmax(clear_m, middle_m);
      (is_clear(from_m, to_m) ? good_m : other_m) = middle_m;
    }
    return good_m;
  }

 private:
  const Path& path_;
  const std::vector<OffsetBoundary>& boundaries_;
};

/// The flat end of a swath that is to be extended.
struct SwathEnd {
  Point at, along;
  double half_m = 0;

  Point local(Point p) const { return {dot(p - at, along), cross(along, p - at)}; }
};

/// Distance it may go until it meets the ring, m. What touches its end already is not in the way.
double run_to_edges_m(const SwathEnd& end, const SwathLimit& limit, double most_m) {
  const double half_m = end.half_m - limit.beside_m;
  const Ring& ring = limit.ring;
  double out = most_m;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Point a = end.local(ring[i]), b = end.local(ring[(i + 1) % ring.size()]);
    if (a.y > b.y) std::swap(a, b);
    if (b.y < -half_m || a.y > half_m || std::max(a.x, b.x) < -kSamePlace_m || std::min(a.x, b.x) > out)
      continue;
    const auto x_at = [&](double y) { return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x); };
    const double first = a.y < -half_m ? x_at(-half_m) : a.x, last = b.y > half_m ? x_at(half_m) : b.x;
    if (std::max(first, last) < -kSamePlace_m) continue;
    out = std::min(out, std::max(0.0, std::min(first, last)));
  }
  return out;
}

/// Distance it may go until its sides or its front come nearer to the ring than `distance_m`, m.
double run_beside_m(const SwathEnd& end, const Ring& ring, double distance_m, double most_m) {
  const auto keeps_off = [&](double run_m) {
    const Point left{0, end.half_m}, right{0, -end.half_m}, on{run_m, 0};
    const PathSegment sides[] = {{left, left + on, 0}, {right, right + on, 0}, {left + on, right + on, 0}};
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const PathSegment& side : sides)
        if (distance_to_edge(side, end.local(ring[i]), end.local(ring[(i + 1) % ring.size()])) <
            distance_m - kBeside_m)
          return false;
    return true;
  };
  if (keeps_off(most_m)) return most_m;
  constexpr int kHalvings = 24;
  double clear_m = 0, other_m = most_m;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_m = 0.5 * (clear_m + other_m);
    (keeps_off(middle_m) ? clear_m : other_m) = middle_m;
  }
  return clear_m;
}

double free_run_m(const SwathEnd& end, const std::vector<SwathLimit>& limits, double most_m) {
  double out = most_m;
  for (const SwathLimit& limit : limits) {
    out = run_to_edges_m(end, limit, out);
    if (limit.distance_m > 0) out = run_beside_m(end, limit.ring, limit.distance_m, out);
  }
  return out;
}

void go_on(Path& path, double by_m) {
  if (by_m < kNoRun_m) return;
  const Point along = direction_at_end(path.back());
  const Point end = path.back().to + by_m * along;
  if (path.back().straight())
    path.back().to = end;
  else
    path.push_back({path.back().to, end, 0});
}

}  // namespace

std::vector<Path> clear_stretches(const Path& path, const std::vector<OffsetBoundary>& offset_boundaries,
                                  double step_m) {
  const double length_m = length(path);
  const Clearance clearance(path, offset_boundaries);
  if (clearance.is_clear(0, length_m)) return {path};
  const std::size_t count = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length_m / step_m)));
  const auto at = [&](std::size_t i) {
    return length_m * static_cast<double>(i) / static_cast<double>(count);
  };
  std::vector<char> clear;
  for (std::size_t i = 0; i < count; ++i) clear.push_back(clearance.is_clear(at(i), at(i + 1)) ? 1 : 0);
  std::vector<std::pair<double, double>> runs;
  for (std::size_t i = 0; i < count; ++i) {
    if (clear[i] == 0) continue;
    const std::size_t first = i;
    while (i + 1 < count && clear[i + 1] != 0) ++i;
    runs.emplace_back(first == 0 ? 0 : clearance.end_of_clear(at(first), at(first - 1)),
                      i + 1 == count ? length_m : clearance.end_of_clear(at(i + 1), at(i + 2)));
  }
  if (runs.size() > 1 && runs.front().first == 0 && runs.back().second == length_m &&
      distance(path.front().from, path.back().to) < kSamePlace_m) {
    runs.back().second = length_m + runs.front().second;
    runs.erase(runs.begin());
  }
  std::vector<Path> out;
  for (const auto& [from_m, to_m] : runs)
    if (Path part = stretch_of(path, from_m, to_m); !part.empty()) out.push_back(std::move(part));
  return out;
}

Path driven_on(Path path, const std::vector<SwathLimit>& limits, double width_m, double most_m) {
  go_on(path, free_run_m({path.back().to, direction_at_end(path.back()), 0.5 * width_m}, limits, most_m));
  return path;
}

Path driven_to_the_end(Path path, const std::vector<SwathLimit>& limits, double width_m, double most_m) {
  for (int end = 0; end < 2; ++end) path = reversed(driven_on(std::move(path), limits, width_m, most_m));
  return path;
}

}  // namespace tramline
