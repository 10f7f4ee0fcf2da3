#include "tramline/geometry/offset/offset_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The angle clockwise from the arc's start; a little less than 0 for points just before it.
double clockwise(const OffsetCurve& arc, Point p) {
  const Point d = p - arc.centre;
  const double angle = std::atan2(-cross(arc.along, d), dot(arc.along, d));
  const double before = -0.5 * (2 * std::numbers::pi - arc.extent);  // as far from the end as from the start
  return angle < before ? angle + 2 * std::numbers::pi : angle;
}

bool lies_on(const OffsetCurve& curve, Point p) {
  const double slack = curve.straight() ? kTouch_m : kTouch_m / curve.radius;
  const double position = position_on(curve, p);
  return position >= -slack && position <= curve.extent + slack;
}

void ends_on_each_other(const OffsetCurve& a, const OffsetCurve& b, std::vector<Point>& out) {
  for (const Point p : {a.from, a.to})
    if (lies_on(b, p)) out.push_back(p);
  for (const Point p : {b.from, b.to})
    if (lies_on(a, p)) out.push_back(p);
}

void lines(const OffsetCurve& a, const OffsetCurve& b, std::vector<Point>& out) {
  const double sine = cross(a.along, b.along);
  const Point between = b.from - a.from;
  if (std::abs(sine) > kParallelCurves_rad)
    out.push_back(a.from + (cross(between, b.along) / sine) * a.along);
  // Lines that part by less than a touch over their length.
  if (std::abs(cross(a.along, between)) < kTouch_m && std::abs(cross(a.along, b.to - a.from)) < kTouch_m)
    ends_on_each_other(a, b, out);
}

void line_and_circle(const OffsetCurve& line, const OffsetCurve& arc, std::vector<Point>& out) {
  const Point foot = line.from + dot(arc.centre - line.from, line.along) * line.along;
  const double off = distance(foot, arc.centre);
  if (off > arc.radius + kTouch_m) return;
  const double half = std::sqrt(std::max(0.0, (arc.radius - off) * (arc.radius + off)));
  out.push_back(foot - half * line.along);
  out.push_back(foot + half * line.along);
}

void circles(const OffsetCurve& a, const OffsetCurve& b, std::vector<Point>& out) {
  const Point between = b.centre - a.centre;
  const double apart = length(between);
  if (apart < kTouch_m) {
    if (std::abs(a.radius - b.radius) < kTouch_m) ends_on_each_other(a, b, out);
    return;
  }
  if (apart > a.radius + b.radius + kTouch_m || apart < std::abs(a.radius - b.radius) - kTouch_m) return;
  const Point unit = (1 / apart) * between;
  const double ahead = 0.5 * (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart);
  const double aside = std::sqrt(std::max(0.0, (a.radius - ahead) * (a.radius + ahead)));
  for (const double side : {-aside, aside})
    out.push_back(a.centre + ahead * unit + side * Point{-unit.y, unit.x});
}

}  // namespace

OffsetCurve offset_line(Point from, Point to) {
  assert(from != to);
  OffsetCurve out;
  out.from = from;
  out.to = to;
  out.extent = distance(from, to);
  out.along = (1 / out.extent) * (to - from);
  out.box = bounds(from, to).grown(kTouch_m);
  return out;
}

OffsetCurve offset_arc(Point centre, double radius_m, Point from, Point to) {
  assert(std::abs(distance(centre, from) - radius_m) <= kPathRadius_share * (1 + radius_m));
  assert(std::abs(distance(centre, to) - radius_m) <= kPathRadius_share * (1 + radius_m));
  OffsetCurve out;
  out.from = from;
  out.to = to;
  out.along = (1 / radius_m) * (from - centre);
  out.radius = radius_m;
  out.centre = centre;
  const Point a = from - centre, b = to - centre;
  out.extent = std::abs(std::atan2(cross(b, a), dot(a, b)));
  out.box = bounds(from, to);
  for (const Point pole : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}})
    if (lies_on(out, centre + radius_m * pole)) out.box.extend(centre + radius_m * pole);
  out.box = out.box.grown(kTouch_m);
  return out;
}

double position_on(const OffsetCurve& curve, Point p) {
  return curve.straight() ? dot(p - curve.from, curve.along) : clockwise(curve, p);
}

Point point_at(const OffsetCurve& curve, double position) {
  if (curve.straight()) return curve.from + position * curve.along;
  const double c = std::cos(position), s = std::sin(position);
  const Point u = curve.along;
  return curve.centre + curve.radius * Point{c * u.x + s * u.y, c * u.y - s * u.x};
}

Point heading_at(const OffsetCurve& curve, Point p) {
  if (curve.straight()) return curve.along;
  const Point out = p - curve.centre;
  return (1 / length(out)) * Point{out.y, -out.x};
}

std::vector<Point> meetings(const OffsetCurve& a, const OffsetCurve& b) {
  std::vector<Point> out;
  if (!intersects(a.box, b.box)) return out;
  if (a.straight() && b.straight())
    lines(a, b, out);
  else if (a.straight())
    line_and_circle(a, b, out);
  else if (b.straight())
    line_and_circle(b, a, out);
  else
    circles(a, b, out);
  std::erase_if(out, [&](Point p) { return !lies_on(a, p) || !lies_on(b, p); });
  return out;
}

}  // namespace tramline
