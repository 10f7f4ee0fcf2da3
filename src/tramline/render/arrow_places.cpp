#include "tramline/render/arrow_places.h"

#include <algorithm>

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

std::optional<Point> arrow_place(const TrackPiece& piece, double room_m, const Box& seen) {
  const auto whole = clipped(piece.start, piece.end, seen);
  if (!whole) return std::nullopt;
  const Point middle = midpoint(whole->first, whole->second);
  std::optional<Point> best;
  for (const PathSegment& part : straight_parts(piece)) {
    const auto visible = clipped(part.from, part.to, seen);
    if (!visible) continue;
    const auto [from, to] = *visible;
    const double run = distance(from, to);
    if (run <= room_m) continue;
    const double margin = 0.5 * room_m / run;
    const double wanted = dot(middle - from, to - from) / (run * run);
    const double share = std::clamp(wanted, margin, 1 - margin);
    const Point place = share == wanted ? middle : from + share * (to - from);
    if (!best || distance(place, middle) < distance(*best, middle)) best = place;
  }
  return best;
}

}  // namespace tramline::render
