#include "tramline/io/export/thinned_line.h"

#include <fmt/format.h>

#include <cassert>
#include <cstddef>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

struct Farthest {
  std::size_t at = 0;
  double off_m = 0;
};

/// Of the vertices between two others, the one farthest from the line through these; the first of equals.
Farthest farthest(const std::vector<Point>& line, std::size_t first, std::size_t last) {
  Farthest out{first, 0};
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off_m = distance_to_segment(line[i], line[first], line[last]);
    if (off_m > out.off_m) out = {i, off_m};
  }
  return out;
}

}  // namespace

std::vector<Point> thinned(const std::vector<Point>& line, double tolerance_m) {
  assert(tolerance_m >= 0);
  if (line.size() < 3 || tolerance_m <= 0) return line;
  std::vector<char> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  // Not by recursion: a line may have a hundred thousand vertices.
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const Farthest corner = farthest(line, first, last);
    if (corner.off_m <= tolerance_m) continue;
    kept[corner.at] = 1;
    open.emplace_back(first, corner.at);
    open.emplace_back(corner.at, last);
  }
  std::vector<Point> out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) out.push_back(line[i]);
  return out;
}

void require_tolerance(double tolerance_m) {
  constexpr double kMost_m = 10;
  if (!(tolerance_m >= 0 && tolerance_m <= kMost_m))
    throw bad_input(fmt::format("--tolerance must be from 0 to {} m, not {}", kMost_m, tolerance_m));
}

}  // namespace tramline::io
