#include "tramline/geometry/path/simplified_line.h"

#include <utility>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

std::vector<std::size_t> distinct_points(const std::vector<Point>& line) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (out.empty() || distance(line[i], line[out.back()]) > kSamePlace_m) out.push_back(i);
  // The last vertex stays: a vertex that nearly coincides with it gives way.
  if (out.size() > 1) out.back() = line.size() - 1;
  return out;
}

}  // namespace

std::vector<std::size_t> simplified_line(const std::vector<Point>& line, double tolerance_m) {
  std::vector<std::size_t> distinct = distinct_points(line);
  if (tolerance_m <= 0 || distinct.size() < 3) return distinct;
  std::vector<bool> kept(distinct.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, distinct.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance_m;
    std::size_t at = last;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_to_segment(line[distinct[i]], line[distinct[first]], line[distinct[last]]);
      if (off > farthest) {
        farthest = off;
        at = i;
      }
    }
    if (at == last) continue;
    kept[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) out.push_back(distinct[i]);
  return out;
}

}  // namespace tramline
