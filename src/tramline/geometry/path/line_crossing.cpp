#include "tramline/geometry/path/line_crossing.h"

#include <algorithm>
#include <cassert>

#include "tramline/geometry/index/box_grid.h"

namespace tramline {
namespace {

int side(double cross_product) { return (cross_product > 0) - (cross_product < 0); }

bool on_segment(Point p, Point a, Point b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool have_common_point(Point a, Point b, Point c, Point d) {
  const int at_c = side(cross(b - a, c - a)), at_d = side(cross(b - a, d - a));
  const int at_a = side(cross(d - c, a - c)), at_b = side(cross(d - c, b - c));
  if (at_c != at_d && at_a != at_b && at_c * at_d <= 0 && at_a * at_b <= 0) return true;
  return (at_c == 0 && on_segment(c, a, b)) || (at_d == 0 && on_segment(d, a, b)) ||
         (at_a == 0 && on_segment(a, c, d)) || (at_b == 0 && on_segment(b, c, d));
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> self_crossing(const std::vector<Point>& line) {
  assert(std::adjacent_find(line.begin(), line.end()) == line.end());
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) boxes.push_back(bounds(line[i], line[i + 1]));
  const BoxGrid grid(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::size_t first = boxes.size();
    grid.each_meeting(boxes[i], [&](std::size_t j) {
      if (j > i + 1 && j < first && have_common_point(line[i], line[i + 1], line[j], line[j + 1])) first = j;
    });
    if (first < boxes.size()) return std::pair{i, first};
  }
  return std::nullopt;
}

std::optional<double> crossing_along(Point a, Point b, Point c, Point d) {
  const Point along = b - a, other = d - c;
  const double turn = cross(along, other);
  if (turn == 0) return std::nullopt;
  const double t = cross(c - a, other) / turn, u = cross(c - a, along) / turn;
  if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
  return t;
}

}  // namespace tramline
