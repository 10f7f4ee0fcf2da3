#include "tramline/check/measure/swath_clearance.h"

#include <algorithm>
#include <cmath>

#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// An arc of at most half a circle leaves its chord by no more than half of that.
Box box_of(const PathSegment& segment) {
  const Box out = bounds(segment.from, segment.to);
  return segment.straight() ? out : out.grown(0.5 * distance(segment.from, segment.to));
}

/// Whether the path goes forwards along the piece all the way. Headings on an arc lie between those at its
/// ends, on the side of its chord's.
bool goes_forwards(const Path& path) {
  return std::all_of(path.begin(), path.end(), [](const PathSegment& segment) {
    return direction_at_start(segment).y >= -kRounding && direction_at_end(segment).y >= -kRounding &&
           segment.to.y >= segment.from.y - kShortest_m;
  });
}

double distance_to(Point p, Point a, Point b) { return distance_to_edge({a, b, 0}, p, p); }

}  // namespace

SwathClearance::SwathClearance(const PieceFrame& frame, const Path& path, double half_width_m)
    : frame_(frame),
      path_(moved(path, [&frame](Point p) { return frame.to_local(p); })),
      half_m_(half_width_m),
      from_m_(path_.front().from.y),
      to_m_(path_.back().to.y) {
  for (const PathSegment& segment : path_) {
    boxes_.push_back(box_of(segment));
    box_.extend(boxes_.back());
  }
  if (goes_forwards(path_)) return;
  from_m_ = -kInfinity;
  to_m_ = kInfinity;
}

Box SwathClearance::field_box(double reach_m) const {
  return frame_.field_box(box_.grown(half_m_ + std::max(0.0, reach_m)));
}

bool SwathClearance::cut_to_length(Edge& edge) const {
  const double begin = from_m_ + kLengthTolerance_m, end = to_m_ - kLengthTolerance_m;
  if (edge.a.y > edge.b.y) std::swap(edge.a, edge.b);
  if (begin > end || edge.a.y > end || edge.b.y < begin) return false;
  const Edge whole = edge;
  const auto at = [&whole](double y) {
    return whole.a + ((y - whole.a.y) / (whole.b.y - whole.a.y)) * (whole.b - whole.a);
  };
  if (whole.a.y < begin) edge.a = at(begin);
  if (whole.b.y > end) edge.b = at(end);
  return true;
}

void SwathClearance::approach(const Edge& edge, double reach_m, Approach& best) const {
  const auto keep = [&](double gap_m, const PathSegment& to, const Edge& of) {
    if (gap_m >= best.gap_m) return;
    const bool a_is_nearer = distance_to_edge(to, of.a, of.a) < distance_to_edge(to, of.b, of.b);
    best = {gap_m, frame_.to_field(a_is_nearer ? of.a : of.b)};
  };
  if (reach_m > 0 && std::isfinite(from_m_))
    for (const Point end : {path_.front().from, path_.back().to}) {
      const PathSegment flat{end - Point{half_m_, 0}, end + Point{half_m_, 0}, 0};
      keep(distance_to_edge(flat, edge.a, edge.b), flat, edge);
    }
  Edge beside = edge;
  if (!cut_to_length(beside)) return;
  const Box box = bounds(beside.a, beside.b).grown(half_m_ + std::max(0.0, reach_m));
  for (std::size_t i = 0; i < path_.size(); ++i)
    if (intersects(box, boxes_[i]))
      keep(distance_to_edge(path_[i], beside.a, beside.b) - half_m_, path_[i], beside);
}

std::vector<SwathClearance::Edge> SwathClearance::near_edges(const Ring& ring, double reach_m) const {
  std::vector<Edge> out;
  if (ring.empty()) return out;
  const Box near = box_.grown(half_m_ + std::max(0.0, reach_m));
  Point a = frame_.to_local(ring.back());
  for (const Point vertex : ring) {
    const Point b = frame_.to_local(vertex);
    if (intersects(bounds(a, b), near)) out.push_back({a, b});
    a = b;
  }
  return out;
}

Approach SwathClearance::to_ring(const Ring& ring, double reach_m) const {
  Approach best;
  for (const Edge& edge : near_edges(ring, reach_m)) approach(edge, reach_m, best);
  return best;
}

Approach SwathClearance::to_land(const Polygon& land, double reach_m) const {
  Approach best = to_ring(land.outer, reach_m);
  for (const Ring& hole : land.holes)
    if (const Approach other = to_ring(hole, reach_m); other.gap_m < best.gap_m) best = other;
  // Land far wider than the swath has no edge near it.
  const Point inside = some_point();
  if (best.gap_m > -half_m_ && contains(land, inside)) best = {-half_m_, inside};
  return best;
}

Point SwathClearance::some_point() const {
  const std::vector<Point> points = chords(path_, kLengthTolerance_m);
  const std::size_t middle = points.size() / 2;
  return frame_.to_field(points.size() > 2 ? points[middle] : midpoint(points.front(), points.back()));
}

std::optional<Point> SwathClearance::point_outside(const std::vector<Edge>& near, const Ring& outer,
                                                   Judged judged, Point from, Point to) const {
  // Between its crossings of the ring the chord is inside or outside as a whole.
  std::vector<double> shares{0, 1};
  const Point along = to - from;
  for (const Edge& edge : near) {
    const Point side = edge.b - edge.a;
    const double turn = cross(along, side);
    if (turn == 0) continue;
    const double t = cross(edge.a - from, side) / turn, u = cross(edge.a - from, along) / turn;
    if (t > 0 && t < 1 && u >= 0 && u <= 1) shares.push_back(t);
  }
  std::sort(shares.begin(), shares.end());
  for (std::size_t i = 0; i + 1 < shares.size(); ++i)
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Point p = from + (shares[i] + share * (shares[i + 1] - shares[i])) * along;
      if (contains(outer, frame_.to_field(p))) continue;
      if (judged == Judged::kWhereLineIsInside && !contains(outer, frame_.to_field({0, p.y}))) continue;
      const bool touches = std::any_of(near.begin(), near.end(), [p](const Edge& edge) {
        return distance_to(p, edge.a, edge.b) <= kLengthTolerance_m;
      });
      if (!touches) return frame_.to_field(p);
    }
  return std::nullopt;
}

std::optional<Point> SwathClearance::point_outside(const Ring& outer, Judged judged) const {
  const std::vector<Edge> near = near_edges(outer, 0);
  if (near.empty()) {
    const Point anywhere = some_point();
    return contains(outer, anywhere) ? std::nullopt : std::optional(anywhere);
  }
  const std::vector<Point> line = chords(path_, kSideSagitta_m);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    if (const auto point = point_outside(near, outer, judged, line[i], line[i + 1])) return point;
  return std::nullopt;
}

std::optional<Point> SwathClearance::point_outside(const Ring& outer) const {
  return point_outside(outer, Judged::kEverywhere);
}

std::optional<Point> SwathClearance::point_pushed_outside(const Ring& outer) const {
  return point_outside(outer, Judged::kWhereLineIsInside);
}

}  // namespace tramline::check
