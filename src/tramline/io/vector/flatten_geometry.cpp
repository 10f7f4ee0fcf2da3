#include "tramline/io/vector/flatten_geometry.h"

#include <ogr_geometry.h>

#include <memory>

namespace tramline::io {
namespace {

// A chord of 1 degree leaves out 1 − sin(1°)/1° = 0.005 % of a circle.
constexpr double kArcStepDegrees = 1;

class Flattener {
 public:
  Flattener(AxisOrder axes, RawFeature& feature) : axes_(axes), feature_(feature) {}

  void add(const OGRGeometry* g) {
    switch (wkbFlatten(g->getGeometryType())) {
      case wkbPoint:
        if (!g->IsEmpty()) feature_.points.push_back(point(g->toPoint()->getX(), g->toPoint()->getY()));
        break;
      case wkbLineString:
        feature_.lines.push_back(points_of(g->toLineString()));
        break;
      case wkbPolygon:
      case wkbTriangle:
        add_polygon(g->toPolygon());
        break;
      case wkbMultiPoint:
      case wkbMultiLineString:
      case wkbMultiPolygon:
      case wkbGeometryCollection:
        for (const OGRGeometry* part : g->toGeometryCollection()) add(part);
        break;
      case wkbPolyhedralSurface:
      case wkbTIN:
        for (const OGRPolygon* part : g->toPolyhedralSurface()) add_polygon(part);
        break;
      default:
        break;
    }
  }

 private:
  Point point(double x, double y) const { return axes_ == AxisOrder::kYFirst ? Point{y, x} : Point{x, y}; }

  std::vector<Point> points_of(const OGRSimpleCurve* line) const {
    std::vector<Point> out;
    out.reserve(static_cast<std::size_t>(line->getNumPoints()));
    for (int i = 0; i < line->getNumPoints(); ++i) out.push_back(point(line->getX(i), line->getY(i)));
    return out;
  }

  void add_polygon(const OGRPolygon* polygon) {
    RawPolygon out;
    for (const OGRLinearRing* ring : polygon) {
      RawRing raw{points_of(ring), true};
      raw.closed = raw.points.size() > 1 && raw.points.front() == raw.points.back();
      if (raw.closed) raw.points.pop_back();
      out.rings.push_back(std::move(raw));
    }
    if (!out.rings.empty()) feature_.polygons.push_back(std::move(out));
  }

  AxisOrder axes_;
  RawFeature& feature_;
};

}  // namespace

void flatten_geometry(const OGRGeometry* geometry, AxisOrder axes, RawFeature& feature) {
  if (geometry == nullptr) {
    feature.geometry_type = "none";
    return;
  }
  feature.geometry_type = OGRGeometryTypeToName(wkbFlatten(geometry->getGeometryType()));
  feature.had_z = geometry->Is3D() != 0;
  feature.had_m = geometry->IsMeasured() != 0;
  feature.was_curved = geometry->hasCurveGeometry() != 0;
  Flattener flattener(axes, feature);
  if (feature.was_curved) {
    const std::unique_ptr<OGRGeometry> linear(geometry->getLinearGeometry(kArcStepDegrees));
    flattener.add(linear.get());
  } else {
    flattener.add(geometry);
  }
}

}  // namespace tramline::io
