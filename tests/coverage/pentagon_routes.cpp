#include "coverage/pentagon_routes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline::coverage::testing_routes {
namespace {

constexpr double kW = kRouteWidth_m;
constexpr double kStep_m = 1;

enum class RowEnds {
  kStripExtent,  ///< as far as there is field anywhere in the row's strip
  kCentreLine,   ///< where the row's centre line meets the boundary
};

/// How the machine gets from one row to the next, working.
enum class Legs {
  kNone,           ///< it does not
  kDirect,         ///< straight from end to end
  kPerpendicular,  ///< square to the rows: both reach as far as the farther one
  kAlongOrSquare,  ///< straight along the edge where the field widens; where it narrows square to the rows,
                   ///< the next one beginning as far out as the last one ended
};

struct Description {
  const char* name;
  Point from, to;  ///< the edge that the first row touches, driven in this direction
  RowEnds ends;
  Legs legs;
  double covered_m2, repeated_m2, missed_m2;
};

constexpr Point kA1{7.5, 5}, kA2{32.5, 5}, kA3{42.5, 30}, kA4{5, 37.5}, kA5{2, 20};

constexpr Description kDescriptions[] = {
    {"A3A2, strip extent, no legs", kA3, kA2, RowEnds::kStripExtent, Legs::kNone, 1074.437, 0, 0},
    {"A3A2, strip extent, direct legs", kA3, kA2, RowEnds::kStripExtent, Legs::kDirect, 1169.827, 95.391, 0},
    {"A3A2, strip extent, perpendicular legs", kA3, kA2, RowEnds::kStripExtent, Legs::kPerpendicular,
     1241.916, 72.000, 0},
    {"A3A4, strip extent, no legs", kA3, kA4, RowEnds::kStripExtent, Legs::kNone, 1055.267, 0, 0},
    {"A3A4, strip extent, direct legs", kA3, kA4, RowEnds::kStripExtent, Legs::kDirect, 1113.551, 58.284, 0},
    {"A3A4, strip extent, perpendicular legs", kA3, kA4, RowEnds::kStripExtent, Legs::kPerpendicular,
     1136.524, 56.000, 0},
    {"A1A2, strip extent, no legs", kA1, kA2, RowEnds::kStripExtent, Legs::kNone, 1090.743, 0, 0},
    {"A1A2, strip extent, direct legs", kA1, kA2, RowEnds::kStripExtent, Legs::kDirect, 1180.402, 89.659, 0},
    {"A1A2, strip extent, perpendicular legs", kA1, kA2, RowEnds::kStripExtent, Legs::kPerpendicular,
     1245.981, 64.000, 0},
    {"A1A2, centre line, direct legs", kA1, kA2, RowEnds::kCentreLine, Legs::kDirect, 1076.732, 91.284,
     12.499},
    {"A1A2, centre line, legs along the edge or square", kA1, kA2, RowEnds::kCentreLine, Legs::kAlongOrSquare,
     1127.151, 58.370, 12.499},
};

/// The pentagon seen along an edge: `along` from its first corner, `depth` into the field.
struct Frame {
  Point origin, u, n;

  Frame(Point from, Point to) : origin(from), u((1 / distance(from, to)) * (to - from)), n{-u.y, u.x} {
    const Point inside{20, 20};
    if (dot(inside - from, n) < 0) n = {-n.x, -n.y};
  }
  double along(Point p) const { return dot(p - origin, u); }
  double depth(Point p) const { return dot(p - origin, n); }
  Point place(double along_m, double depth_m) const { return origin + along_m * u + depth_m * n; }
};

/// The extent along the edge of what the pentagon has between two depths; low > high: nothing.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double along) {
    low = std::min(low, along);
    high = std::max(high, along);
  }
};

Extent extent(const Frame& frame, double from_depth, double to_depth) {
  constexpr double kRounding_m = 1e-9;
  const Ring ring = pentagon().front().outer;
  Extent out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double at_a = frame.depth(a), at_b = frame.depth(b);
    if (at_a > from_depth - kRounding_m && at_a < to_depth + kRounding_m) out.take(frame.along(a));
    for (const double depth : {from_depth, to_depth})
      if ((at_a < depth) != (at_b < depth))
        out.take(frame.along(a + (depth - at_a) / (at_b - at_a) * (b - a)));
  }
  return out;
}

std::vector<Extent> rows_of(const Frame& frame, RowEnds ends) {
  std::vector<Extent> out;
  for (int row = 0;; ++row) {
    const bool strip = ends == RowEnds::kStripExtent;
    const Extent one = extent(frame, (row + (strip ? 0.0 : 0.5)) * kW, (row + (strip ? 1.0 : 0.5)) * kW);
    if (one.low > one.high) return out;
    out.push_back(one);
  }
}

/// Rows made longer so that legs can be square to them. Even rows are driven towards `high`.
void lengthen(std::vector<Extent>& rows, Legs legs) {
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    Extent &row = rows[i], &next = rows[i + 1];
    const bool at_high = i % 2 == 0;
    if (legs == Legs::kPerpendicular && at_high) row.high = next.high = std::max(row.high, next.high);
    if (legs == Legs::kPerpendicular && !at_high) row.low = next.low = std::min(row.low, next.low);
    if (legs == Legs::kAlongOrSquare && at_high) next.high = std::max(row.high, next.high);
    if (legs == Legs::kAlongOrSquare && !at_high) next.low = std::min(row.low, next.low);
  }
}

void append_run(Point from, Point to, PentagonRoute& route) {
  const double length_m = distance(from, to);
  const Point forward = (1 / length_m) * (to - from), left = 0.5 * kW * Point{-forward.y, forward.x};
  route.rectangles.push_back({from + left, from - left, to - left, to + left});
  const int run = static_cast<int>(route.rectangles.size()) - 1;
  const int parts = static_cast<int>(std::ceil(length_m / kStep_m));
  const auto place = [&](int part) {
    const double share = static_cast<double>(part) / parts;
    return (1 - share) * from + share * to;
  };
  for (int i = 0; i < parts; ++i) {
    const Point rear = place(i), front = place(i + 1);
    const Quad quad{rear + left, rear - left, front - left, front + left};
    route.steps.push_back({{quad}, run, length_m * (i + 1) / parts, kW, route.steps.size()});
  }
}

PentagonRoute route(const Description& d) {
  const Frame frame(d.from, d.to);
  std::vector<Extent> rows = rows_of(frame, d.ends);
  lengthen(rows, d.legs);
  PentagonRoute out{d.name, {}, {}, d.covered_m2, d.repeated_m2, d.missed_m2};
  Point at;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double depth = (static_cast<double>(i) + 0.5) * kW;
    const Point low = frame.place(rows[i].low, depth), high = frame.place(rows[i].high, depth);
    const Point begin = i % 2 == 0 ? low : high, end = i % 2 == 0 ? high : low;
    if (i > 0 && d.legs != Legs::kNone) append_run(at, begin, out);
    append_run(begin, end, out);
    at = end;
  }
  return out;
}

}  // namespace

Region pentagon() { return {{{kA1, kA2, kA3, kA4, kA5}, {}}}; }

std::vector<PentagonRoute> routes() {
  std::vector<PentagonRoute> out;
  for (const Description& description : kDescriptions) out.push_back(route(description));
  return out;
}

}  // namespace tramline::coverage::testing_routes
