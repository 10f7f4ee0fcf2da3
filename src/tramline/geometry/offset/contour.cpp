#include "tramline/geometry/offset/contour.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

ContourElement element_of(const PathSegment& segment) {
  ContourElement out;
  out.from = segment.from;
  out.heading = direction_at_start(segment);
  out.heading_to = direction_at_end(segment);
  out.length = length(segment);
  out.straight = segment.straight();
  if (out.straight) return out;
  out.signed_radius = 1 / segment.curvature;
  out.turn = turning(segment);
  // From the tangent and not from the chord, so that tangents of parallels stay continuous.
  out.centre = segment.from + out.signed_radius * left_of(out.heading);
  out.half_cosine = std::cos(0.5 * out.turn);
  return out;
}

ContourElement quarter_turn(Point about, Point heading) {
  ContourElement out;
  out.from = out.centre = about;
  out.heading = heading;
  out.heading_to = left_of(heading);
  out.turn = 0.5 * std::numbers::pi;
  out.half_cosine = std::sqrt(0.5);
  out.length = 1;
  out.cap = true;
  return out;
}

bool nearer_than(const ContourElement& e, Point p, double distance_m) {
  const Point d = p - e.from;
  if (e.straight) {
    const double along = std::clamp(dot(d, e.heading), 0.0, e.length);
    const Point off = d - along * e.heading;
    return dot(off, off) < distance_m * distance_m;
  }
  if (dot(d, d) < distance_m * distance_m) return true;
  // The far end begins the next element; that of the last one is looked at by the caller.
  const Point from_centre = p - e.centre;
  const double away = std::sqrt(dot(from_centre, from_centre)), radius = std::abs(e.signed_radius);
  if (std::abs(away - radius) >= distance_m) return false;
  const Point outward = (e.signed_radius > 0 ? -1.0 : 1.0) * left_of(e.heading + e.heading_to);
  const double norm = 2 * std::abs(e.half_cosine);
  if (norm < kHalfTurn_rad) return dot(from_centre, e.heading) >= 0;  // half a circle
  return dot(from_centre, outward) >= e.half_cosine * away * norm;
}

Box box_of(const ContourElement& e) {
  Box box;
  box.extend(e.from);
  if (e.straight) {
    box.extend(e.from + e.length * e.heading);
    return box;
  }
  box.extend(e.centre - e.signed_radius * left_of(e.heading_to));
  return box.grown(std::abs(e.signed_radius) * (1 - e.half_cosine));
}

/// Boxes of the segments first … last − 1 and of all that they are put together from.
Box add_boxes(const Contour& contour, std::size_t first, std::size_t last, std::vector<ContourBox>& out) {
  const std::size_t own = out.size();
  out.emplace_back();
  Box box;
  if (last - first == 1) {
    box = box_of(contour.elements[first]);
    out[own].single = true;
    out[own].element = first;
  } else {
    const std::size_t middle = (first + last) / 2;
    box = add_boxes(contour, first, middle, out);
    box.extend(add_boxes(contour, middle, last, out));
  }
  out[own].box = box;
  out[own].skip = out.size();
  return box;
}

bool reaches_into(Point p, double distance_m, const Box& box) {
  const double dx = std::max({box.min_x - p.x, 0.0, p.x - box.max_x});
  const double dy = std::max({box.min_y - p.y, 0.0, p.y - box.max_y});
  return dx * dx + dy * dy < distance_m * distance_m;
}

}  // namespace

Contour contour_of(const Path& path) {
  assert(std::all_of(path.begin(), path.end(), [](const PathSegment& s) { return s.from != s.to; }));
  Contour out;
  out.segments = path.size();
  const auto add = [&out](ContourElement element) {
    element.start = out.elements.empty() ? 0 : out.elements.back().start + out.elements.back().length;
    out.elements.push_back(element);
  };
  const auto add_half_turn = [&out, &add](Point about) {
    add(quarter_turn(about, out.elements.back().heading_to));
    add(quarter_turn(about, out.elements.back().heading_to));
  };
  for (const PathSegment& segment : path) add(element_of(segment));
  out.path_length = out.elements.back().start + out.elements.back().length;
  add_half_turn(path.back().to);
  for (const PathSegment& segment : reversed(path)) add(element_of(segment));
  add_half_turn(path.front().from);
  out.boxes.reserve(2 * out.segments);
  add_boxes(out, 0, out.segments, out.boxes);
  return out;
}

std::size_t element_at(const Contour& contour, double position) {
  const auto next = std::lower_bound(contour.elements.begin() + 1, contour.elements.end(), position,
                                     [](const ContourElement& e, double s) { return e.start < s; });
  return static_cast<std::size_t>(next - contour.elements.begin()) - 1;
}

Point heading_at(const ContourElement& element, double position) {
  if (element.straight || position <= element.start) return element.heading;
  if (position >= element.start + element.length) return element.heading_to;
  return turned(element.heading, element.turn * (position - element.start) / element.length);
}

Point beside(const ContourElement& element, double position, double distance_m) {
  if (element.straight)
    return element.from + std::clamp(position - element.start, 0.0, element.length) * element.heading -
           distance_m * left_of(element.heading);
  return element.centre - (element.signed_radius + distance_m) * left_of(heading_at(element, position));
}

void append_parallel(const Contour& contour, double from, double to, double distance_m, Path& out) {
  Point at = out.empty() ? Point{} : out.back().to;
  bool going_on = !out.empty();
  for (std::size_t i = element_at(contour, from); i < contour.elements.size(); ++i) {
    const ContourElement& e = contour.elements[i];
    const double low = std::max(from, e.start), high = std::min(to, e.start + e.length);
    if (e.start >= to) break;
    if (high - low <= kShortest_m) continue;
    if (!going_on) at = beside(e, low, distance_m);
    going_on = true;
    const Point end = beside(e, high, distance_m);
    // Where headings agree up to rounding, a short part may end behind the end of the one before.
    const bool ahead = dot(end - at, heading_at(e, 0.5 * (low + high))) > 0;
    if (!ahead || distance(at, end) <= kShortest_m) continue;
    out.push_back({at, end, curvature_beside(e, distance_m)});
    at = end;
  }
}

bool keeps_away(const Contour& contour, Point p, double distance_m, std::size_t& hint) {
  if (nearer_than(contour.elements[hint], p, distance_m)) return false;
  for (std::size_t i = 0; i < contour.boxes.size();) {
    const ContourBox& part = contour.boxes[i];
    if (!reaches_into(p, distance_m, part.box)) {
      i = part.skip;
      continue;
    }
    if (part.single && nearer_than(contour.elements[part.element], p, distance_m)) {
      hint = part.element;
      return false;
    }
    ++i;
  }
  const Point off = p - contour.elements[contour.segments].centre;
  return dot(off, off) >= distance_m * distance_m;
}

}  // namespace tramline
