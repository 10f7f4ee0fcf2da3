#include "tramline/render/page/visible_stretches.h"

#include <algorithm>
#include <cassert>

namespace tramline::render {

// After Liang and Barsky.
std::optional<std::pair<Point, Point>> clipped(Point a, Point b, const Box& box) {
  double from = 0, to = 1;
  const Point d = b - a;
  const auto keep_where = [&](double step, double room) {  // step · t <= room
    if (step == 0) return room >= 0;
    const double t = room / step;
    if (step < 0) from = std::max(from, t);
    if (step > 0) to = std::min(to, t);
    return from < to;
  };
  const bool some = keep_where(-d.x, a.x - box.min_x) && keep_where(d.x, box.max_x - a.x) &&
                    keep_where(-d.y, a.y - box.min_y) && keep_where(d.y, box.max_y - a.y);
  if (!some) return std::nullopt;
  return std::pair{from == 0 ? a : a + from * d, to == 1 ? b : a + to * d};
}

std::vector<std::vector<Point>> stretches_in(const std::vector<Point>& line, const Box& box) {
  std::vector<std::vector<Point>> out;
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto part = clipped(line[i], line[i + 1], box);
    if (part && goes_on && part->first == line[i])
      out.back().push_back(part->second);
    else if (part)
      out.push_back({part->first, part->second});
    goes_on = part && part->second == line[i + 1];
  }
  return out;
}

double length_of(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
  return sum;
}

PointOnLine point_along(const std::vector<Point>& line, double run) {
  assert(line.size() >= 2);
  PointOnLine out{line.front(), {}};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double chord = distance(line[i], line[i + 1]);
    if (chord == 0) continue;
    out.along = (1 / chord) * (line[i + 1] - line[i]);
    out.at = line[i] + std::min(run, chord) * out.along;
    if (run <= chord) break;
    run -= chord;
  }
  return out;
}

}  // namespace tramline::render
