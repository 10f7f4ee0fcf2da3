#include "tramline/headland/clear_stretches.h"

#include <algorithm>
#include <cmath>
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

}  // namespace tramline
