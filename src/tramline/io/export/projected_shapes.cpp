#include "tramline/io/export/projected_shapes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "tramline/geometry/error.h"
#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

Point vertex(const OGRSimpleCurve& line, int i, Point offset) {
  return Point{line.getX(i), line.getY(i)} - offset;
}

void append(OGRSimpleCurve& line, Point p) { line.addPoint(plain_zero(p.x), plain_zero(p.y)); }

/// Metres between the middle of the exported edge and the line through a and b.
double aside(Point a, Point b, Point target_a, Point target_b, const TargetCrs& target) {
  const double length = distance(a, b);
  const std::optional<Point> middle = target.to_local(0.5 * (target_a + target_b));
  if (length == 0 || !middle) return 0;
  return std::abs(cross(b - a, *middle - a)) / length;
}

/// Parts that an edge has to be cut into: in halves it is off by a quarter.
int parts(Point a, Point b, Point target_a, Point target_b, const TargetCrs& target, double most_aside_m) {
  if (target.plain()) return 1;
  constexpr double kMostParts = 1000;
  const double off = aside(a, b, target_a, target_b, target);
  return static_cast<int>(std::clamp(std::ceil(std::sqrt(off / most_aside_m)), 1.0, kMostParts));
}

void project_line(const OGRSimpleCurve& from, Point offset, const TargetCrs& target, double most_aside_m,
                  OGRSimpleCurve& to) {
  if (from.getNumPoints() == 0) return;
  Point last = vertex(from, 0, offset);
  Point target_last = target.from_local(last);
  append(to, target_last);
  for (int i = 1; i < from.getNumPoints(); ++i) {
    const Point next = vertex(from, i, offset);
    const Point target_next = target.from_local(next);
    const int n = parts(last, next, target_last, target_next, target, most_aside_m);
    for (int part = 1; part < n; ++part)
      append(to, target.from_local(last + (static_cast<double>(part) / n) * (next - last)));
    append(to, target_next);
    last = next;
    target_last = target_next;
  }
}

}  // namespace

std::unique_ptr<OGRGeometry> projected(const OGRGeometry& shape, Point offset, const TargetCrs& target,
                                       double most_aside_m) {
  assert(most_aside_m > 0);
  switch (wkbFlatten(shape.getGeometryType())) {
    case wkbPoint: {
      const Point p = target.from_local(Point{shape.toPoint()->getX(), shape.toPoint()->getY()} - offset);
      return std::make_unique<OGRPoint>(plain_zero(p.x), plain_zero(p.y));
    }
    case wkbLineString: {
      auto out = std::make_unique<OGRLineString>();
      project_line(*shape.toLineString(), offset, target, most_aside_m, *out);
      return out;
    }
    case wkbPolygon: {
      auto out = std::make_unique<OGRPolygon>();
      for (const OGRLinearRing* ring : *shape.toPolygon()) {
        auto closed = std::make_unique<OGRLinearRing>();
        project_line(*ring, offset, target, most_aside_m, *closed);
        out->addRingDirectly(closed.release());
      }
      return out;
    }
    case wkbMultiPolygon: {
      auto out = std::make_unique<OGRMultiPolygon>();
      for (const OGRPolygon* polygon : *shape.toMultiPolygon())
        out->addGeometryDirectly(projected(*polygon, offset, target, most_aside_m).release());
      return out;
    }
    default:
      throw bad_input("the plan holds a shape that is no point, line or polygon; write it again");
  }
}

}  // namespace tramline::io
