#include "tramline/cost/bound/ring_in_strip.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace tramline {
namespace {

/// Calls visit(across, along) for both ends of what each edge has between two values of one coordinate.
/// Precondition: between.from <= between.to.
template <double Point::*kAcross, double Point::*kAlong, class Visit>
void each_end_between(const Ring& ring, const Interval& between, Visit visit) {
  assert(between.from <= between.to);
  Point a = ring.back();
  for (const Point b : ring) {
    const Point from = a;
    a = b;
    const double start = from.*kAcross, end = b.*kAcross;
    if (std::max(start, end) < between.from || std::min(start, end) > between.to) continue;
    for (const Point corner : {from, b}) {
      const double across = std::clamp(corner.*kAcross, between.from, between.to);
      visit(across, start == end
                        ? corner.*kAlong
                        : from.*kAlong + (b.*kAlong - from.*kAlong) * ((across - start) / (end - start)));
    }
  }
}

}  // namespace

Interval extent_along(const Ring& ring, double left, double right) {
  Interval out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  if (left > right) return out;
  each_end_between<&Point::x, &Point::y>(ring, {left, right}, [&](double, double y) {
    out = {std::min(out.from, y), std::max(out.to, y)};
  });
  return out;
}

std::vector<Point> corners_in(const Ring& ring, const Interval& rows) {
  std::vector<Point> out;
  each_end_between<&Point::y, &Point::x>(ring, rows, [&](double y, double x) { out.push_back({x, y}); });
  return out;
}

bool has_no_bays(const Ring& ring) {
  int turns = 0, sense = 0, first = 0;
  Point a = ring.back();
  for (const Point b : ring) {
    const double dx = b.x - a.x;
    a = b;
    if (dx == 0) continue;
    const int now = dx > 0 ? 1 : -1;
    if (sense == 0) first = now;
    turns += sense != 0 && now != sense ? 1 : 0;
    sense = now;
  }
  return turns + (sense != first ? 1 : 0) <= 2;
}

std::vector<Point> ends_within(const Ring& ring, const Box& box) {
  std::vector<Point> out;
  Point a = ring.back();
  for (const Point b : ring) {
    const Point from = a;
    a = b;
    double first = 0, last = 1;  // shares of the edge
    const auto clip = [&](double start, double end, double low, double high) {
      if (start == end) {
        if (start < low || start > high) last = -1;
        return;
      }
      const double at_low = (low - start) / (end - start), at_high = (high - start) / (end - start);
      first = std::max(first, std::min(at_low, at_high));
      last = std::min(last, std::max(at_low, at_high));
    };
    clip(from.x, b.x, box.min_x, box.max_x);
    clip(from.y, b.y, box.min_y, box.max_y);
    if (first > last) continue;
    for (const double share : {first, last}) out.push_back(from + share * (b - from));
  }
  return out;
}

}  // namespace tramline
