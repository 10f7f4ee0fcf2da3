#include "tramline/geometry/polygon/region.h"

#include <algorithm>
#include <cmath>

namespace tramline {

void Box::extend(Point p) {
  min_x = std::min(min_x, p.x);
  min_y = std::min(min_y, p.y);
  max_x = std::max(max_x, p.x);
  max_y = std::max(max_y, p.y);
}

void Box::extend(const Box& other) {
  min_x = std::min(min_x, other.min_x);
  min_y = std::min(min_y, other.min_y);
  max_x = std::max(max_x, other.max_x);
  max_y = std::max(max_y, other.max_y);
}

bool intersects(const Box& a, const Box& b) {
  return a.min_x <= b.max_x && b.min_x <= a.max_x && a.min_y <= b.max_y && b.min_y <= a.max_y;
}

Box bounds(const Ring& ring) {
  Box box;
  for (const Point p : ring) box.extend(p);
  return box;
}

Box bounds(const Polygon& polygon) { return bounds(polygon.outer); }

Box bounds(const Region& region) {
  Box box;
  for (const Polygon& polygon : region) box.extend(bounds(polygon));
  return box;
}

double signed_area(const Ring& ring) {
  if (ring.size() < 3) return 0;
  double twice = 0;
  const Point origin = ring.front();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - origin, ring[i + 1] - origin);
  return 0.5 * twice;
}

double area(const Polygon& polygon) {
  double sum = std::abs(signed_area(polygon.outer));
  for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  return sum;
}

double area(const Region& region) {
  double sum = 0;
  for (const Polygon& polygon : region) sum += area(polygon);
  return sum;
}

double perimeter(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += distance(ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Polygon oriented(Polygon polygon) {
  if (signed_area(polygon.outer) < 0) polygon.outer = reversed(std::move(polygon.outer));
  for (Ring& hole : polygon.holes)
    if (signed_area(hole) > 0) hole = reversed(std::move(hole));
  return polygon;
}

std::vector<Ring> rings_of(const Region& region) {
  std::vector<Ring> rings;
  for (const Polygon& polygon : region) {
    rings.push_back(polygon.outer);
    rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return rings;
}

bool contains(const Ring& ring, Point p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[i], b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

bool contains(const Polygon& polygon, Point p) {
  return contains(polygon.outer, p) && std::none_of(polygon.holes.begin(), polygon.holes.end(),
                                                    [p](const Ring& h) { return contains(h, p); });
}

bool contains(const Region& region, Point p) {
  return std::any_of(region.begin(), region.end(), [p](const Polygon& q) { return contains(q, p); });
}

std::size_t vertex_count(const Region& region) {
  std::size_t count = 0;
  for (const Polygon& polygon : region) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

}  // namespace tramline
