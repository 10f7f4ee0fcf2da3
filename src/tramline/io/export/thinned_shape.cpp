#include "tramline/io/export/thinned_shape.h"

#include <utility>
#include <vector>

#include "tramline/io/export/thinned_line.h"

namespace tramline::io {
namespace {

void thin(const OGRSimpleCurve& from, double tolerance_m, OGRSimpleCurve& to) {
  std::vector<Point> line;
  for (int i = 0; i < from.getNumPoints(); ++i) line.push_back({from.getX(i), from.getY(i)});
  for (const Point p : thinned(line, tolerance_m)) to.addPoint(p.x, p.y);
}

std::unique_ptr<OGRGeometry> thinned_polygon(const OGRPolygon& polygon, double tolerance_m) {
  auto out = std::make_unique<OGRPolygon>();
  for (const OGRLinearRing* ring : polygon) {
    auto closed = std::make_unique<OGRLinearRing>();
    thin(*ring, tolerance_m, *closed);
    // A triangle has four points, the last one being the first.
    if (closed->getNumPoints() < 4) return std::unique_ptr<OGRGeometry>(polygon.clone());
    out->addRingDirectly(closed.release());
  }
  if (!out->IsValid()) return std::unique_ptr<OGRGeometry>(polygon.clone());
  return out;
}

}  // namespace

std::unique_ptr<OGRGeometry> thinned_shape(const OGRGeometry& shape, double tolerance_m) {
  switch (wkbFlatten(shape.getGeometryType())) {
    case wkbLineString: {
      auto out = std::make_unique<OGRLineString>();
      thin(*shape.toLineString(), tolerance_m, *out);
      return out;
    }
    case wkbPolygon:
      return thinned_polygon(*shape.toPolygon(), tolerance_m);
    case wkbMultiPolygon: {
      auto out = std::make_unique<OGRMultiPolygon>();
      for (const OGRPolygon* polygon : *shape.toMultiPolygon())
        out->addGeometryDirectly(thinned_polygon(*polygon, tolerance_m).release());
      return out;
    }
    default:
      return std::unique_ptr<OGRGeometry>(shape.clone());
  }
}

}  // namespace tramline::io
