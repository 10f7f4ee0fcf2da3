#pragma once
// Lines and arcs at a fixed distance from edges and corners, with positions along them as numbers.

#include <vector>

#include "tramline/geometry/path/path.h"

namespace tramline {

/// A straight line, or an arc driven clockwise of at most half a circle.
struct OffsetCurve {
  Point from;
  Point to;
  Point along;        ///< unit vector: of the line, or from the arc's centre to its start
  double extent = 0;  ///< length of the line, or angle of the arc
  double radius = 0;  ///< 0: a line
  Point centre{};     ///< of an arc
  Box box{};          ///< contains the curve, with a small margin

  bool straight() const { return radius == 0; }
};

/// Precondition: from != to.
OffsetCurve offset_line(Point from, Point to);
/// Precondition: the two points lie on the circle; from `from` clockwise to `to` it is half a circle at most.
OffsetCurve offset_arc(Point centre, double radius_m, Point from, Point to);

/// Length or angle from the curve's start to the point of it that is nearest to `p`, which has to lie near
/// the curve or its carrier.
double position_on(const OffsetCurve& curve, Point p);
Point point_at(const OffsetCurve& curve, double position);
/// Unit vector in driving direction.
Point heading_at(const OffsetCurve& curve, Point p);
/// 1/m, positive to the left.
inline double curvature(const OffsetCurve& curve) { return curve.straight() ? 0 : -1 / curve.radius; }

/// The points where two curves meet, the ends of both included, up to kTouch_m. For curves on one line or one
/// circle: the ends of each that lie on the other. Every point lies on both carriers up to rounding, however
/// flat the crossing. O(1).
std::vector<Point> meetings(const OffsetCurve& a, const OffsetCurve& b);

}  // namespace tramline
