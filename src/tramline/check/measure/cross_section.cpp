#include "tramline/check/measure/cross_section.h"

#include <algorithm>
#include <cmath>

#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

struct SectionEdge {
  Point a;
  Point b;
};

/// The edges of the land that a cross-section of the piece can cross, in the piece's frame.
std::vector<SectionEdge> edges_beside(const Polygon& land, const PieceFrame& frame) {
  std::vector<SectionEdge> out;
  const auto append = [&](const Ring& ring) {
    if (ring.empty()) return;
    Point a = frame.to_local(ring.back());
    for (const Point vertex : ring) {
      const Point b = frame.to_local(vertex);
      if (std::max(a.y, b.y) >= 0 && std::min(a.y, b.y) <= frame.length()) out.push_back({a, b});
      a = b;
    }
  };
  append(land.outer);
  for (const Ring& hole : land.holes) append(hole);
  return out;
}

/// Where along the piece the length inside may bend or jump, sorted, with both ends of the piece.
std::vector<double> breakpoints(const std::vector<SectionEdge>& edges, double length_m, double half_m) {
  std::vector<double> out{0, length_m};
  const auto keep = [&](double s) {
    if (s > 0 && s < length_m) out.push_back(s);
  };
  for (const SectionEdge& edge : edges) {
    if (std::min(edge.a.x, edge.b.x) > half_m || std::max(edge.a.x, edge.b.x) < -half_m) continue;
    if (std::abs(edge.a.x) <= half_m) keep(edge.a.y);
    if (std::abs(edge.b.x) <= half_m) keep(edge.b.y);
    for (const double side : {-half_m, half_m})
      if ((edge.a.x < side) != (edge.b.x < side))
        keep(edge.a.y + (edge.b.y - edge.a.y) * (side - edge.a.x) / (edge.b.x - edge.a.x));
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Length of the cross-section at s that lies inside, even-odd. `crossings` is scratch.
double inside_at(const std::vector<SectionEdge>& edges, double s, double half_m,
                 std::vector<double>& crossings) {
  crossings.clear();
  for (const SectionEdge& edge : edges)
    if ((edge.a.y > s) != (edge.b.y > s))
      crossings.push_back(edge.a.x + (edge.b.x - edge.a.x) * (s - edge.a.y) / (edge.b.y - edge.a.y));
  std::sort(crossings.begin(), crossings.end());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    sum += std::max(0.0, std::min(crossings[i + 1], half_m) - std::max(crossings[i], -half_m));
  return sum;
}

}  // namespace

void LongestStretch::add(const Stretch& stretch) {
  if (current_.length() > 0 && stretch.from_m <= current_.to_m + kShortest_m) {
    current_.to_m = stretch.to_m;
    current_.least_m = std::min(current_.least_m, stretch.least_m);
  } else {
    current_ = stretch;
  }
  if (current_.length() > best_.length()) best_ = current_;
}

void add_along_straight(const Polygon& land, const PieceFrame& frame, double half_m, double required_m,
                        double begin_m, LongestStretch& out) {
  const std::vector<SectionEdge> edges = edges_beside(land, frame);
  const std::vector<double> positions = breakpoints(edges, frame.length(), half_m);
  std::vector<double> scratch;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    const double from = positions[i], gap = positions[i + 1] - from;
    if (gap <= kNoStretch_m) continue;
    // Linear in between: two looks well away from the vertices give the values at both ends.
    const double at_quarter = inside_at(edges, from + 0.25 * gap, half_m, scratch);
    const double at_three_quarters = inside_at(edges, from + 0.75 * gap, half_m, scratch);
    const double slope = 2 * (at_three_quarters - at_quarter);
    const double first = at_quarter - 0.25 * slope, last = at_quarter + 0.75 * slope;
    if (first >= required_m && last >= required_m) continue;
    const double crossing = slope != 0 ? (required_m - first) / slope : 0;
    const double begin = first < required_m ? 0 : crossing, end = last < required_m ? 1 : crossing;
    out.add({begin_m + from + begin * gap, begin_m + from + end * gap, std::min(first, last)});
  }
}

}  // namespace tramline::check
