#include "tramline/geometry/polygon/boolean.h"

#include <geos_c.h>

#include <algorithm>
#include <cassert>
#include <cstdarg>
#include <cstdio>
#include <memory>

#include "tramline/geometry/error.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

constexpr double kMitreLimit = 2;
constexpr int kRoundSegments = 8;

/// GEOS's re-entrant handle of this thread, with the last error it reported.
class Context {
 public:
  Context() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(
        handle_, [](const char* text, void* self) { static_cast<Context*>(self)->last_error_ = text; }, this);
    GEOSContext_setNoticeMessageHandler_r(
        handle_, [](const char*, void*) {}, nullptr);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { GEOS_finish_r(handle_); }
  GEOSContextHandle_t handle() const { return handle_; }
  const std::string& last_error() const { return last_error_; }

 private:
  GEOSContextHandle_t handle_;
  std::string last_error_;
};

Context& context() {
  thread_local Context instance;
  return instance;
}
GEOSContextHandle_t geos() { return context().handle(); }

struct Destroy {
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(geos(), g); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

Geometry checked(GEOSGeometry* raw, const char* operation) {
  if (raw == nullptr)
    throw failure(std::string("polygon ") + operation + " failed: " + context().last_error());
  return Geometry(raw);
}

GEOSCoordSequence* sequence_of(const std::vector<Point>& points, bool close) {
  const std::size_t n = points.size();
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos(), static_cast<unsigned>(n + (close ? 1 : 0)), 2);
  for (std::size_t i = 0; i < n; ++i)
    GEOSCoordSeq_setXY_r(geos(), sequence, static_cast<unsigned>(i), points[i].x, points[i].y);
  if (close) GEOSCoordSeq_setXY_r(geos(), sequence, static_cast<unsigned>(n), points[0].x, points[0].y);
  return sequence;
}

Geometry to_line(const std::vector<Point>& points, bool close) {
  return checked(GEOSGeom_createLineString_r(geos(), sequence_of(points, close)), "line");
}

Geometry to_geos(const Polygon& polygon) {
  GEOSGeometry* shell = GEOSGeom_createLinearRing_r(geos(), sequence_of(polygon.outer, true));
  if (shell == nullptr) return checked(nullptr, "ring");
  std::vector<GEOSGeometry*> holes;
  for (const Ring& hole : polygon.holes)
    holes.push_back(GEOSGeom_createLinearRing_r(geos(), sequence_of(hole, true)));
  return checked(GEOSGeom_createPolygon_r(geos(), shell, holes.data(), static_cast<unsigned>(holes.size())),
                 "polygon");
}

Geometry collect(std::vector<Geometry> parts, int type) {
  std::vector<GEOSGeometry*> raw;
  for (Geometry& part : parts) raw.push_back(part.release());
  return checked(GEOSGeom_createCollection_r(geos(), type, raw.data(), static_cast<unsigned>(raw.size())),
                 "collection");
}

Geometry to_geos(const Region& region) {
  std::vector<Geometry> parts;
  for (const Polygon& polygon : region)
    if (polygon.outer.size() >= 3) parts.push_back(to_geos(polygon));
  return collect(std::move(parts), GEOS_MULTIPOLYGON);
}

std::vector<Point> points_of(const GEOSGeometry* line) {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(geos(), line);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(geos(), sequence, &size);
  std::vector<Point> out(size);
  for (unsigned i = 0; i < size; ++i) GEOSCoordSeq_getXY_r(geos(), sequence, i, &out[i].x, &out[i].y);
  return out;
}

Ring ring_from(const GEOSGeometry* closed_line) {
  Ring out = points_of(closed_line);
  if (!out.empty()) out.pop_back();
  return out;
}

void append_polygons(const GEOSGeometry* g, Region& out) {
  const int type = GEOSGeomTypeId_r(geos(), g);
  if (type == GEOS_POLYGON) {
    if (GEOSisEmpty_r(geos(), g)) return;
    Polygon polygon;
    polygon.outer = ring_from(GEOSGetExteriorRing_r(geos(), g));
    for (int i = 0; i < GEOSGetNumInteriorRings_r(geos(), g); ++i)
      polygon.holes.push_back(ring_from(GEOSGetInteriorRingN_r(geos(), g, i)));
    out.push_back(oriented(std::move(polygon)));
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    for (int i = 0; i < GEOSGetNumGeometries_r(geos(), g); ++i)
      append_polygons(GEOSGetGeometryN_r(geos(), g, i), out);
  }
}

Region from_geos(const Geometry& g) {
  Region out;
  append_polygons(g.get(), out);
  return out;
}

Region united(const Region& polygons) {
  return from_geos(checked(GEOSUnaryUnionPrec_r(geos(), to_geos(polygons).get(), kGridSize), "union"));
}

using Operation = GEOSGeometry*(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*, double);

/// Polygons of one region may overlap a little: those of GEOS's own buffers do, in rare places. GEOS lays
/// such regions over others only once their polygons are united.
Region overlay(const Region& a, const Region& b, Operation* operation, const char* name) {
  if (GEOSGeometry* found = operation(geos(), to_geos(a).get(), to_geos(b).get(), kGridSize))
    return from_geos(Geometry(found));
  return from_geos(
      checked(operation(geos(), to_geos(united(a)).get(), to_geos(united(b)).get(), kGridSize), name));
}

Point point_inside(const Polygon& polygon) {
  const Geometry point = checked(GEOSPointOnSurface_r(geos(), to_geos(polygon).get()), "interior point");
  Point p;
  GEOSGeomGetX_r(geos(), point.get(), &p.x);
  GEOSGeomGetY_r(geos(), point.get(), &p.y);
  return p;
}

}  // namespace

Region unite(const Region& polygons) { return united(polygons); }
Region unite(const Region& a, const Region& b) { return overlay(a, b, GEOSUnionPrec_r, "union"); }
Region intersection(const Region& a, const Region& b) {
  return overlay(a, b, GEOSIntersectionPrec_r, "intersection");
}
Region difference(const Region& a, const Region& b) {
  return overlay(a, b, GEOSDifferencePrec_r, "difference");
}
Region symmetric_difference(const Region& a, const Region& b) {
  return overlay(a, b, GEOSSymDifferencePrec_r, "symmetric difference");
}

namespace {

Region buffered_by_geos(const Region& region, double distance_m, JoinStyle join, int segments_per_quadrant) {
  const int style = join == JoinStyle::kRound ? GEOSBUF_JOIN_ROUND : GEOSBUF_JOIN_MITRE;
  return from_geos(
      checked(GEOSBufferWithStyle_r(geos(), to_geos(region).get(), distance_m, segments_per_quadrant,
                                    GEOSBUF_CAP_ROUND, style, kMitreLimit),
              "buffer"));
}

/// Of rings with up to so many vertices GEOS guesses whether they erode to nothing, and where some of their
/// edges are short it guesses wrong now and then (BufferCurveSetBuilder::isRingCurveInverted, GEOS 3.11).
constexpr std::size_t kMostGuessed = 8;

/// The same ring with more vertices than GEOS guesses of.
Ring with_edges_split(const Ring& ring) {
  const std::size_t parts = kMostGuessed / ring.size() + 1;
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], way = ring[(i + 1) % ring.size()] - from;
    for (std::size_t k = 0; k < parts; ++k)
      out.push_back(from + (static_cast<double>(k) / static_cast<double>(parts)) * way);
  }
  return out;
}

}  // namespace

Region buffered(const Region& region, double distance_m, JoinStyle join, int segments_per_quadrant) {
  Region out = buffered_by_geos(region, distance_m, join, segments_per_quadrant);
  if (distance_m >= 0) return out;
  for (const Polygon& part : region) {
    if (part.outer.size() < 3 || part.outer.size() > kMostGuessed) continue;
    const bool vanished = region.size() == 1
                              ? out.empty()
                              : buffered_by_geos({part}, distance_m, join, segments_per_quadrant).empty();
    if (!vanished) continue;
    for (Polygon& left : buffered_by_geos({{with_edges_split(part.outer), part.holes}}, distance_m, join,
                                          segments_per_quadrant))
      out.push_back(std::move(left));
  }
  return out;
}

Region buffered_line(const std::vector<Point>& line, double distance_m) {
  assert(std::any_of(line.begin(), line.end(), [&line](Point p) { return p != line.front(); }));
  return from_geos(
      checked(GEOSBufferWithStyle_r(geos(), to_line(line, false).get(), distance_m, kRoundSegments,
                                    GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, kMitreLimit),
              "line buffer"));
}

Region line_neighbourhood(Point a, Point b, double distance_m) {
  return from_geos(checked(GEOSBuffer_r(geos(), to_line({a, b}, false).get(), distance_m, kRoundSegments),
                           "line neighbourhood"));
}

double distance_between(const Region& a, const Region& b) {
  double out = 0;
  if (!GEOSDistance_r(geos(), to_geos(a).get(), to_geos(b).get(), &out)) checked(nullptr, "distance");
  return out;
}

double distance_to_ring(const Region& region, const Ring& ring) {
  double out = 0;
  if (!GEOSDistance_r(geos(), to_geos(region).get(), to_line(ring, true).get(), &out))
    checked(nullptr, "distance");
  return out;
}

Disc largest_disc(const Polygon& polygon, double tolerance_m) {
  const Geometry shape = to_geos(polygon);
  // A line from the centre to the nearest point of the boundary.
  const Geometry spoke = checked(GEOSMaximumInscribedCircle_r(geos(), shape.get(), tolerance_m), "disc");
  const GEOSCoordSequence* ends = GEOSGeom_getCoordSeq_r(geos(), spoke.get());
  Disc disc;
  Point rim;
  GEOSCoordSeq_getXY_r(geos(), ends, 0, &disc.centre.x, &disc.centre.y);
  GEOSCoordSeq_getXY_r(geos(), ends, 1, &rim.x, &rim.y);
  disc.radius_m = distance(disc.centre, rim);
  return disc;
}

Region convex_hull(const std::vector<Point>& points) {
  if (points.size() < 3) return {};
  return from_geos(checked(GEOSConvexHull_r(geos(), to_line(points, false).get()), "convex hull"));
}

std::optional<Invalidity> find_invalidity(const Polygon& polygon) {
  char* reason = nullptr;
  GEOSGeometry* place = nullptr;
  const char valid = GEOSisValidDetail_r(geos(), to_geos(polygon).get(), 0, &reason, &place);
  std::unique_ptr<char, void (*)(void*)> reason_owner(reason, [](void* p) { GEOSFree_r(geos(), p); });
  Geometry place_owner(place);
  if (valid == 1) return std::nullopt;
  Invalidity out{reason != nullptr ? reason : "not a valid polygon", {}};
  if (place != nullptr) {
    GEOSGeomGetX_r(geos(), place, &out.place.x);
    GEOSGeomGetY_r(geos(), place, &out.place.y);
  }
  return out;
}

Region made_valid(const Polygon& polygon) {
  return from_geos(checked(GEOSMakeValid_r(geos(), to_geos(polygon).get()), "repair"));
}

Region triangles_of(const Polygon& polygon) {
  return from_geos(
      checked(GEOSConstrainedDelaunayTriangulation_r(geos(), to_geos(polygon).get()), "triangulation"));
}

Region split_by_lines(const Polygon& polygon, const std::vector<std::vector<Point>>& lines) {
  std::vector<Geometry> edges;
  edges.push_back(to_line(polygon.outer, true));
  for (const Ring& hole : polygon.holes) edges.push_back(to_line(hole, true));
  for (const auto& line : lines) edges.push_back(to_line(line, false));
  const Geometry linework = collect(std::move(edges), GEOS_MULTILINESTRING);
  // Snap rounding: cut lines that all but coincide meet in one line instead of a sliver.
  const Geometry noded = checked(GEOSUnaryUnionPrec_r(geos(), linework.get(), kGridSize), "noding");
  const GEOSGeometry* input = noded.get();
  const Region faces = from_geos(checked(GEOSPolygonize_r(geos(), &input, 1), "polygonise"));

  Region inside;
  for (const Polygon& face : faces)
    if (contains(polygon, point_inside(face))) inside.push_back(face);
  return inside;
}

double length_inside(const Region& region, Point a, Point b) {
  const Geometry line = to_line({a, b}, false);
  const Geometry inside =
      checked(GEOSIntersection_r(geos(), to_geos(region).get(), line.get()), "intersection");
  double out = 0;
  if (!GEOSLength_r(geos(), inside.get(), &out)) checked(nullptr, "length");
  return out;
}

}  // namespace tramline
