// Cross-sections along arcs: spokes of a wheel.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/check/measure/cross_section.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// An edge of the land, and the spokes that meet it: between two angles from the arc's middle.
struct ArcEdge {
  Point a;
  Point b;
  double first = 0;
  double last = 0;
};

/// Inside and outside are determined this far left of the cross-section, and followed from there. Its own end
/// is not suitable: an edge of the land may run along it from one end of the arc to the other.
constexpr double kBeyond_m = 1.37e-3;

/// One arc of a path over a piece of land.
class Spokes {
 public:
  Spokes(const Polygon& land, const PathSegment& arc, double half_m)
      : rings_(rings_of({land})),
        centre_(tramline::centre(arc)),
        radius_(radius(arc)),
        sense_(arc.curvature > 0 ? 1 : -1),
        first_(arc.from - centre_),
        length_(tramline::length(arc)),
        middle_(spoke(0.5 * length_)),
        half_(half_m) {
    const Box near = bounds(arc.from, arc.to).grown(0.5 * distance(arc.from, arc.to) + half_m + kBeyond_m);
    for (const Ring& ring : rings_)
      for (std::size_t i = 0; i < ring.size(); ++i)
        keep_near(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], near);
  }

  /// Between two neighbouring positions the same edges cross the swath, and the strip just beyond its left
  /// side is inside all the way or not at all.
  void look_between(double from_m, double to_m) {
    const double first = angle_at(from_m), last = angle_at(to_m);
    met_.clear();
    for (const ArcEdge& edge : edges_)
      if (edge.last >= first && edge.first <= last) met_.push_back(edge);
    const Point beyond = point_at(0.5 * (from_m + to_m), -half_ - kBeyond_m);
    inside_beyond_ = false;
    for (const Ring& ring : rings_)
      if (contains(ring, beyond)) inside_beyond_ = !inside_beyond_;
  }

  /// Length of the cross-section at s, between these positions, that lies inside.
  double inside_at(double s) const {
    const double whole_m = 2 * half_ + kBeyond_m;
    const Point from = point_at(s, -half_ - kBeyond_m), along = point_at(s, half_) - from;
    cuts_.clear();
    for (const ArcEdge& edge : met_) {
      const double side_a = cross(along, edge.a - from), side_b = cross(along, edge.b - from);
      if ((side_a > 0) == (side_b > 0)) continue;
      const Point at = edge.a + (side_a / (side_a - side_b)) * (edge.b - edge.a);
      const double t = dot(at - from, along) / dot(along, along);
      if (t > 0 && t < 1) cuts_.push_back(t);
    }
    std::sort(cuts_.begin(), cuts_.end());
    double share = 0, begin = kBeyond_m / whole_m;
    bool inside = inside_beyond_;
    for (const double cut : cuts_) {
      if (inside) share += std::max(0.0, cut - begin);
      inside = !inside;
      begin = std::max(begin, cut);
    }
    if (inside) share += 1 - begin;
    return whole_m * share;
  }

  /// Where the length inside may bend or jump, sorted, with both ends of the arc.
  std::vector<double> positions() const {
    std::vector<double> out{0, length_};
    for (const ArcEdge& edge : edges_) {
      keep(edge.a, out);
      keep(edge.b, out);
      const Point along = edge.b - edge.a;
      const double square = dot(along, along);
      if (square == 0) continue;
      const double foot = dot(centre_ - edge.a, along) / square;
      keep_on(edge, foot, out);
      const Point nearest = edge.a + foot * along - centre_;
      for (const double reach : {radius_ - half_, radius_ + half_, radius_ - sense_ * (half_ + kBeyond_m)}) {
        const double rest = (reach * reach - dot(nearest, nearest)) / square;
        if (rest <= 0) continue;
        keep_on(edge, foot - std::sqrt(rest), out);
        keep_on(edge, foot + std::sqrt(rest), out);
      }
    }
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  void keep_near(Point a, Point b, const Box& near) {
    if (!intersects(bounds(a, b), near)) return;
    const auto [first, last] = std::minmax({angle_of(a), angle_of(b)});
    // An edge behind the centre crosses no spoke, or all of them.
    const bool behind = last - first > std::numbers::pi;
    constexpr double kAll = 4;
    edges_.push_back({a, b, behind ? -kAll : first - kRounding, behind ? kAll : last + kRounding});
  }
  double angle_at(double s) const { return (s - 0.5 * length_) / radius_; }
  /// Along the arc, from its middle.
  double angle_of(Point p) const {
    const Point d = p - centre_;
    return sense_ * std::atan2(cross(middle_, d), dot(middle_, d));
  }
  Point spoke(double s) const {
    const double angle = sense_ * s / radius_, c = std::cos(angle), sine = std::sin(angle);
    return {first_.x * c - first_.y * sine, first_.x * sine + first_.y * c};
  }
  Point point_at(double s, double right_m) const {
    return centre_ + (1 + sense_ * right_m / radius_) * spoke(s);
  }
  void keep_on(const ArcEdge& edge, double share, std::vector<double>& out) const {
    if (share > 0 && share < 1) keep(edge.a + share * (edge.b - edge.a), out);
  }
  void keep(Point p, std::vector<double>& out) const {
    const Point d = p - centre_;
    constexpr double kRounding_m = 1e-6;
    if (std::abs(tramline::length(d) - radius_) > half_ + kBeyond_m + kRounding_m) return;
    const double s = 0.5 * length_ + radius_ * angle_of(p);
    if (s > 0 && s < length_) out.push_back(s);
  }

  std::vector<Ring> rings_;  ///< what lies in an odd number of them is inside
  Point centre_;
  double radius_;
  double sense_;  ///< 1: turns left, the centre lies on the left
  Point first_;   ///< from the centre to the arc's start
  double length_;
  Point middle_;  ///< from the centre to the arc's middle
  double half_;
  std::vector<ArcEdge> edges_;
  std::vector<ArcEdge> met_;
  bool inside_beyond_ = false;
  mutable std::vector<double> cuts_;  ///< scratch
};

/// The position between two others, one on either side of the required length, where the length inside equals
/// it.
double crossing(const Spokes& spokes, double below, double above, double required_m) {
  constexpr int kHalvings = 30;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (below + above);
    (spokes.inside_at(middle) < required_m ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

void add_along_arc(Spokes spokes, double required_m, double begin_m, LongestStretch& out) {
  constexpr int kLooks = 8;
  // As near to where it may jump as rounding allows.
  constexpr double kBeside = 1e-6;
  const std::vector<double> positions = spokes.positions();
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    const double gap = positions[i + 1] - positions[i];
    if (gap <= kNoStretch_m) continue;
    spokes.look_between(positions[i], positions[i + 1]);
    double before_at = positions[i], before = spokes.inside_at(before_at + kBeside * gap);
    for (int k = 1; k <= kLooks; ++k) {
      const double at = k == kLooks ? positions[i + 1] : positions[i] + gap * k / kLooks;
      const double inside = spokes.inside_at(k == kLooks ? at - kBeside * gap : at);
      if (before < required_m || inside < required_m) {
        const double from = before < required_m ? before_at : crossing(spokes, at, before_at, required_m);
        const double to = inside < required_m ? at : crossing(spokes, before_at, at, required_m);
        out.add({begin_m + from, begin_m + to, std::min(before, inside)});
      }
      before_at = at;
      before = inside;
    }
  }
}

}  // namespace

Stretch longest_below(const Polygon& land, const Path& path, double half_m, double required_m) {
  LongestStretch longest;
  double begin_m = 0;
  for (const PathSegment& segment : path) {
    if (segment.straight())
      add_along_straight(land, PieceFrame(segment.from, segment.to), half_m, required_m, begin_m, longest);
    else
      add_along_arc(Spokes(land, segment, half_m), required_m, begin_m, longest);
    begin_m += length(segment);
  }
  return longest.best();
}

}  // namespace tramline::check
