#include "tramline/geometry/path/newly_covered_area.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

// --- Shapes to curves --------------------------------------------------------------------------

/// Unit vectors in driving direction at both ends.
struct Headings {
  Point start;
  Point end;
};

/// As direction_at_start and direction_at_end of a path's segment, without angles: this is called for
/// every shape that a search looks at. Precondition: from != to.
Headings headings(Point from, Point to, double curvature) {
  const Point chord = to - from;
  const double along = std::sqrt(dot(chord, chord));
  const double sine = std::clamp(0.5 * along * curvature, -1.0, 1.0);
  const double cosine = std::sqrt((1 - sine) * (1 + sine));
  const Point ahead = (cosine / along) * chord, aside = (sine / along) * left_of(chord);
  return {ahead - aside, ahead + aside};
}

/// An edge of a counter-clockwise ring along which y does not turn.
void append_monotone(const PathSegment& edge, Layer layer, RisingCurves& out) {
  if (edge.from.y < edge.to.y)
    out.push_back({edge.from, edge.to, edge.curvature, layer, -1});
  else if (edge.to.y < edge.from.y)
    out.push_back({edge.to, edge.from, -edge.curvature, layer, 1});
}

/// An edge of a counter-clockwise ring. At most half a circle, so y turns once at most.
void append_edge(const PathSegment& edge, Layer layer, RisingCurves& out) {
  if (edge.from == edge.to) return;
  if (!edge.straight()) {
    const Headings at = headings(edge.from, edge.to, edge.curvature);
    if (at.start.y * at.end.y < 0) {
      const Point middle = edge.from + (1 / edge.curvature) * left_of(at.start);
      const Point turn{middle.x, middle.y + std::copysign(1 / edge.curvature, at.start.y)};
      append_monotone({edge.from, turn, edge.curvature}, layer, out);
      append_monotone({turn, edge.to, edge.curvature}, layer, out);
      return;
    }
  }
  append_monotone(edge, layer, out);
}

/// The curvature `offset_m` to the left of an arc; 0 where the arc shrinks to a point.
double offset_curvature(double curvature, double offset_m) {
  const double shrunk = 1 - curvature * offset_m;
  return shrunk > kRounding_share ? curvature / shrunk : 0;
}

/// The point of the line ab at the height y, the very end point where it is at that height.
Point at_height(Point a, Point b, double y) {
  if (y == a.y) return a;
  if (y == b.y) return b;
  return {a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), y};
}

// --- One curve in the sweep --------------------------------------------------------------------

/// A curve with what the sweep needs of it. Coordinates are relative to a point of the new layer.
struct Bound {
  Point from;
  Point to;
  double curvature = 0;
  double slope = 0;  ///< dx/dy of a straight line
  Point heading;     ///< at from; a unit vector for arcs, any length for straight lines
  double min_x = 0;
  double max_x = 0;
  Layer layer = Layer::kBody;
  int change = 0;

  // State of the sweep.
  double x = 0;      ///< in the middle of the slab
  int side = 0;      ///< 1: right end of counted area, −1: left end, 0: neither
  double since = 0;  ///< y since when it has been so
};

Bound bound(const RisingCurve& curve, Point origin) {
  Bound out{curve.from - origin, curve.to - origin, curve.curvature, 0, {}, 0, 0, curve.layer, curve.change};
  const Point chord = out.to - out.from;
  out.min_x = std::min(out.from.x, out.to.x);
  out.max_x = std::max(out.from.x, out.to.x);
  out.heading = chord;
  if (curve.curvature == 0) {
    out.slope = chord.x / chord.y;
    return out;
  }
  const Headings at = headings(out.from, out.to, curve.curvature);
  out.heading = {at.start.x, std::max(0.0, at.start.y)};
  if (at.start.x * at.end.x < 0) {  // x turns, where the arc heads north
    const double turn = out.from.x + at.start.x * at.start.x / ((1 + out.heading.y) * curve.curvature);
    out.min_x = std::min(out.min_x, turn);
    out.max_x = std::max(out.max_x, turn);
  }
  return out;
}

/// With the start as origin, heading t and curvature k, a point (x, y) of the arc has
/// k·(x² + y²)/2 = t.x·y − t.y·x. This root of it stays exact while k goes to 0.
double x_at(const Bound& b, double y) {
  const double up = y - b.from.y;
  double x = b.from.x;
  if (b.curvature == 0) {
    x += b.slope * up;
  } else {
    const double n = (2 * b.heading.x - b.curvature * up) * up;
    const double d = b.heading.y + std::sqrt(std::max(0.0, b.heading.y * b.heading.y + b.curvature * n));
    if (d > 0) x += n / d;
  }
  return std::min(std::max(x, b.min_x), b.max_x);
}

Point point_at(const Bound& b, double y) {
  if (y <= b.from.y) return b.from;
  if (y >= b.to.y) return b.to;
  return {x_at(b, y), y};
}

/// (asin s − s·√(1 − s²)) / s³: as a series where the difference would lose its digits.
double segment_factor(double s) {
  if (s > 0.1) return (std::asin(s) - s * std::sqrt((1 - s) * (1 + s))) / (s * s * s);
  const double q = s * s;
  return 2. / 3 + q * (1. / 5 + q * (3. / 28 + q * (5. / 72 + q * (35. / 704 + q * (63. / 1664)))));
}

/// ∫ x dy along the curve: the trapezoid under the chord and the segment between chord and arc.
double integral(const Bound& b, double low, double high) {
  const Point p = point_at(b, low), q = point_at(b, high);
  const double trapezoid = 0.5 * (p.x + q.x) * (q.y - p.y);
  if (b.curvature == 0) return trapezoid;
  const Point chord = q - p;
  const double square = dot(chord, chord);
  const double s = std::min(1.0, 0.5 * std::sqrt(square) * std::abs(b.curvature));
  return trapezoid + std::copysign(0.25 * square * s * segment_factor(s), b.curvature);
}

// --- Where curves cross ------------------------------------------------------------------------

/// A range of heights, open at both ends.
struct Heights {
  double low = 0;
  double high = 0;
  bool contain(double y) const { return y > low && y < high; }
};

void append_crossing_of_lines(const Bound& a, const Bound& b, Heights within, std::vector<double>& out) {
  const double below = x_at(a, within.low) - x_at(b, within.low);
  const double above = x_at(a, within.high) - x_at(b, within.high);
  if (below * above < 0) out.push_back(within.low + (within.high - within.low) * (below / (below - above)));
}

/// Both curves as n·p − k·p²/2 + c = 0 about the start of a, the more curved one. The difference of the
/// two without the square is the line g·p = h through both crossings; its meetings with a are sought.
/// Heights that come out inexact or are no crossings do no harm: they only cut slabs elsewhere.
void append_crossings_of_arc(const Bound& a, const Bound& b, Heights within, std::vector<double>& out) {
  const Point n = left_of(a.heading), other_n = left_of(b.heading), apart = b.from - a.from;
  const Point g = b.curvature * n - a.curvature * (other_n + b.curvature * apart);
  const double h = -a.curvature * (dot(other_n, apart) + 0.5 * b.curvature * dot(apart, apart));
  const double square = dot(g, g);
  const Point foot = (h / square) * g, along = (1 / std::sqrt(square)) * left_of(g);
  const double half = dot(n, along);
  const double rest = 2 * dot(n, foot) - a.curvature * dot(foot, foot);
  const double root = half * half + a.curvature * rest;
  // Curves that touch are cut there too: in the middle of a slab they would have no order.
  constexpr double kTouching = -1e-9;
  if (!(root > kTouching)) return;  // apart, or concentric (not a number)
  const double sum = half + std::copysign(std::sqrt(std::max(0.0, root)), half);
  const double left = std::max(a.min_x, b.min_x), right = std::min(a.max_x, b.max_x);
  constexpr double kBeyond_m = 1e-3;  // a crossing at an end of an arc may come out just beyond it
  for (const double t : {sum / a.curvature, -rest / sum}) {
    const Point p = a.from + foot + t * along;
    if (within.contain(p.y) && p.x > left - kBeyond_m && p.x < right + kBeyond_m) out.push_back(p.y);
  }
}

void append_crossings(const Bound& a, const Bound& b, Heights within, std::vector<double>& out) {
  if (a.curvature == 0 && b.curvature == 0)
    append_crossing_of_lines(a, b, within, out);
  else if (std::abs(a.curvature) >= std::abs(b.curvature))
    append_crossings_of_arc(a, b, within, out);
  else
    append_crossings_of_arc(b, a, within, out);
}

// --- The sweep ---------------------------------------------------------------------------------

/// Kept from one call to the next, so that a search does not allocate.
struct Scratch {
  std::vector<Bound> bounds;
  std::vector<Bound*> rising;  ///< the bounds in order of where they start
  std::vector<double> heights;
  std::vector<Bound*> active;  ///< the bounds in the slab, from left to right
};

/// The curves that matter for the new layer: nothing above, below or right of it does, and left of it only
/// the winding number.
Heights collect_bounds(const RisingCurves& curves, Scratch& scratch) {
  scratch.bounds.clear();
  Box ground;
  Point origin;
  for (const RisingCurve& curve : curves) {
    if (curve.layer != Layer::kNew || !(curve.from.y < curve.to.y)) continue;
    if (scratch.bounds.empty()) origin = curve.from;
    const Bound& b = scratch.bounds.emplace_back(bound(curve, origin));
    ground.extend(Box{b.min_x, b.from.y, b.max_x, b.to.y});
  }
  for (const RisingCurve& curve : curves) {
    if (curve.layer == Layer::kNew || !(curve.from.y < curve.to.y)) continue;
    if (curve.from.y - origin.y >= ground.max_y || curve.to.y - origin.y <= ground.min_y) continue;
    Bound b = bound(curve, origin);
    if (b.min_x >= ground.max_x) continue;
    if (b.max_x <= ground.min_x) {
      b.min_x = b.max_x = b.from.x = b.to.x = ground.min_x - 1;
      b.curvature = b.slope = 0;
    }
    scratch.bounds.push_back(b);
  }
  return {ground.min_y, ground.max_y};
}

void sort_by_start(Scratch& scratch) {
  scratch.rising.clear();
  for (Bound& b : scratch.bounds) scratch.rising.push_back(&b);
  std::sort(scratch.rising.begin(), scratch.rising.end(),
            [](const Bound* a, const Bound* b) { return a->from.y < b->from.y; });
}

/// The heights between which no curve begins, ends or crosses another one.
void collect_heights(Heights ground, Scratch& scratch) {
  std::vector<double>& heights = scratch.heights;
  heights.assign({ground.low, ground.high});
  const std::vector<Bound*>& rising = scratch.rising;
  for (std::size_t i = 0; i < rising.size(); ++i) {
    const Bound& a = *rising[i];
    if (ground.contain(a.from.y)) heights.push_back(a.from.y);
    if (ground.contain(a.to.y)) heights.push_back(a.to.y);
    for (std::size_t j = i + 1; j < rising.size() && rising[j]->from.y < a.to.y; ++j) {
      const Bound& b = *rising[j];
      if (a.max_x < b.min_x || b.max_x < a.min_x) continue;
      const Heights common{std::max(ground.low, b.from.y), std::min({ground.high, a.to.y, b.to.y})};
      append_crossings(a, b, common, heights);
    }
  }
  std::sort(heights.begin(), heights.end());
  // Thinner slabs are but rounding.
  constexpr double kThin_m = 1e-12;
  heights.erase(std::unique(heights.begin(), heights.end(),
                            [](double kept, double next) { return next - kept < kThin_m; }),
                heights.end());
}

/// The counted area beside a curve is summed up once when it ends, not slab by slab.
double turn_to_side(Bound& b, int side, double y) {
  if (side == b.side) return 0;
  const double sum = b.side == 0 ? 0 : b.side * integral(b, b.since, y);
  b.side = side;
  b.since = y;
  return sum;
}

/// Curves that end below `y` leave, those that begin below it enter. Gives the counted area that ends.
double replace_active(Scratch& scratch, std::size_t& next, double slab_from, double y) {
  double sum = 0;
  std::vector<Bound*>& active = scratch.active;
  active.erase(std::remove_if(active.begin(), active.end(),
                              [&](Bound* b) {
                                if (b->to.y > y) return false;
                                sum += turn_to_side(*b, 0, slab_from);
                                return true;
                              }),
               active.end());
  for (; next < scratch.rising.size() && scratch.rising[next]->from.y < y; ++next)
    if (scratch.rising[next]->to.y > y) active.push_back(scratch.rising[next]);
  return sum;
}

/// Insertion sort: from slab to slab the order hardly changes.
void sort_by_x_at(double y, std::vector<Bound*>& active) {
  for (std::size_t i = 0; i < active.size(); ++i) {
    Bound* const b = active[i];
    b->x = x_at(*b, y);
    std::size_t place = i;
    for (; place > 0 && active[place - 1]->x > b->x; --place) active[place] = active[place - 1];
    active[place] = b;
  }
}

/// Goes through a slab from left to right. Gives the counted area that ends.
double mark_sides(const std::vector<Bound*>& active, double slab_from) {
  double sum = 0;
  std::array<int, 3> winding{};
  int counted = 0;
  for (Bound* b : active) {
    winding[static_cast<std::size_t>(b->layer)] += b->change;
    const int now = winding[0] > 0 && winding[1] <= 0 && winding[2] > 0 ? 1 : 0;
    sum += turn_to_side(*b, counted - now, slab_from);
    counted = now;
  }
  return sum;
}

}  // namespace

void append_ring(const Ring& ring, Layer layer, const Box& window, RisingCurves& out) {
  if (window.empty()) return;
  // A chain of edges left of the window: only how far it rises or falls in all matters.
  const double left_x = window.min_x - 1;
  double left_from = 0, left_to = 0;
  const auto end_chain = [&] { append_monotone({{left_x, left_from}, {left_x, left_to}}, layer, out); };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double from_y = std::clamp(a.y, window.min_y, window.max_y);
    const double to_y = std::clamp(b.y, window.min_y, window.max_y);
    if (from_y == to_y) continue;
    const Point p = at_height(a, b, from_y), q = at_height(a, b, to_y);
    if (std::min(p.x, q.x) > window.max_x) continue;
    if (std::max(p.x, q.x) >= window.min_x) {
      append_monotone({p, q}, layer, out);
      continue;
    }
    if (left_to != from_y) {
      end_chain();
      left_from = from_y;
    }
    left_to = to_y;
  }
  end_chain();
}

void append_box(const Box& box, Layer layer, const Box& window, RisingCurves& out) {
  const double low = std::max(box.min_y, window.min_y), high = std::min(box.max_y, window.max_y);
  if (!(low < high) || box.max_x < window.min_x || box.min_x > window.max_x) return;
  const double left = box.min_x >= window.min_x ? box.min_x : window.min_x - 1;
  out.push_back({{left, low}, {left, high}, 0, layer, 1});
  if (box.max_x <= window.max_x) out.push_back({{box.max_x, low}, {box.max_x, high}, 0, layer, -1});
}

void append_band(const Path& path, double width_m, Layer layer, RisingCurves& out) {
  assert(2 * smallest_radius(path) >= width_m * (1 - kPathRadius_share));
  const double half = 0.5 * width_m;
  Point left, right;
  bool begun = false;
  for (const PathSegment& segment : path) {
    if (segment.from == segment.to) continue;
    const Headings at = headings(segment.from, segment.to, segment.curvature);
    if (!begun) {
      left = segment.from + half * left_of(at.start);
      right = segment.from - half * left_of(at.start);
      append_edge({left, right}, layer, out);
      begun = true;
    }
    const Point next_left = segment.to + half * left_of(at.end);
    const Point next_right = segment.to - half * left_of(at.end);
    append_edge({right, next_right, offset_curvature(segment.curvature, -half)}, layer, out);
    append_edge({next_left, left, -offset_curvature(segment.curvature, half)}, layer, out);
    left = next_left;
    right = next_right;
  }
  append_edge({right, left}, layer, out);
}

void append_swath_area(const Path& path, double width_m, Layer layer, RisingCurves& out) {
  if (!has_kinks(path)) {
    append_band(path, width_m, layer, out);
    return;
  }
  for (const Ring& cell : kinked_cells(path, width_m)) append_ring(cell, layer, bounds(cell), out);
}

double newly_covered_area(const RisingCurves& curves) {
  thread_local Scratch scratch;
  const Heights ground = collect_bounds(curves, scratch);
  if (scratch.bounds.empty()) return 0;
  sort_by_start(scratch);
  collect_heights(ground, scratch);
  scratch.active.clear();
  double sum = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < scratch.heights.size(); ++i) {
    const double low = scratch.heights[i], middle = 0.5 * (low + scratch.heights[i + 1]);
    sum += replace_active(scratch, next, low, middle);
    sort_by_x_at(middle, scratch.active);
    sum += mark_sides(scratch.active, low);
  }
  for (Bound* b : scratch.active) sum += turn_to_side(*b, 0, scratch.heights.back());
  return sum;
}

}  // namespace tramline
