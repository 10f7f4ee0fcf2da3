#include "tramline/route/order/hop_ground.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tramline::order {
namespace {

/// Pieces end on edges: crossings nearer to an end than this are the end itself, m.
constexpr double kAtEdge_m = 0.01;
/// A hop that touches an obstacle by less does not lead through it, m.
constexpr double kTouchesObstacle_m = 0.1;
/// Nor does one along its side, for which the way round is longer by no more than this share.
constexpr double kAlongSide_share = 0.01;

}  // namespace

HopGround::HopGround(const Field& field, double far_m) : far_m_(far_m) {
  add(field.outer, true);
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kObstacle) add(obstacle.shape.outer, false);
  std::vector<Box> boxes;
  for (const auto& [ring, corner] : edges_) {
    const Ring& points = rings_[ring].ring;
    boxes.push_back(bounds(points[corner], points[(corner + 1) % points.size()]));
  }
  grid_ = BoxGrid(boxes);
}

void HopGround::add(const Ring& ring, bool field) {
  EdgeRing out{ring, {0}, bounds(ring), field};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    out.along_m.push_back(out.along_m.back() + distance(ring[i], ring[(i + 1) % ring.size()]));
    edges_.emplace_back(rings_.size(), i);
  }
  rings_.push_back(std::move(out));
}

std::vector<HopGround::EdgeCrossing> HopGround::edge_crossings(Point from, Point to) const {
  std::vector<EdgeCrossing> out;
  const Point way = to - from;
  const double least = kAtEdge_m / length(way);
  grid_.each_meeting(bounds(from, to), [&](std::size_t edge) {
    const EdgeRing& ring = rings_[edges_[edge].first];
    const std::size_t corner = edges_[edge].second;
    const Point a = ring.ring[corner], b = ring.ring[(corner + 1) % ring.ring.size()];
    const double side_a = cross(way, a - from), side_b = cross(way, b - from);
    if ((side_a > 0) == (side_b > 0)) return;
    const double beside = side_a / (side_a - side_b);
    const Point at = a + beside * (b - a);
    const double share = dot(at - from, way) / dot(way, way);
    if (share <= least || share >= 1 - least) return;
    const double edge_m = ring.along_m[corner + 1] - ring.along_m[corner];
    out.push_back({edges_[edge].first, share, ring.along_m[corner] + beside * edge_m});
  });
  std::sort(out.begin(), out.end(), [](const EdgeCrossing& x, const EdgeCrossing& y) {
    return std::pair(x.ring, x.share) < std::pair(y.ring, y.share);
  });
  return out;
}

bool HopGround::inside(std::size_t ring, Point p) const {
  const Box& box = rings_[ring].box;
  bool out = false;
  grid_.each_meeting({p.x, p.y, std::max(p.x, box.max_x), p.y}, [&](std::size_t edge) {
    if (edges_[edge].first != ring) return;
    const Ring& points = rings_[ring].ring;
    const Point a = points[edges_[edge].second], b = points[(edges_[edge].second + 1) % points.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) out = !out;
  });
  return out;
}

double HopGround::nearest_along_m(const EdgeRing& ring, Point p) const {
  double nearest = std::numeric_limits<double>::infinity(), out = 0;
  for (std::size_t i = 0; i < ring.ring.size(); ++i) {
    const Point a = ring.ring[i], edge = ring.ring[(i + 1) % ring.ring.size()] - a;
    const double square = dot(edge, edge);
    const double share = square > 0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0;
    const Point off = p - (a + share * edge);
    if (dot(off, off) >= nearest) continue;
    nearest = dot(off, off);
    out = ring.along_m[i] + share * (ring.along_m[i + 1] - ring.along_m[i]);
  }
  return out;
}

void HopGround::lead_round(std::size_t number, const std::vector<EdgeCrossing>& crossed, Point from, Point to,
                           Hop& hop) const {
  const EdgeRing& ring = rings_[number];
  std::vector<double> shares{0};
  for (const EdgeCrossing& crossing : crossed) shares.push_back(crossing.share);
  shares.push_back(1);
  // Ends may lie on the edge, where inside and outside are a matter of rounding: the longest stretch decides.
  std::size_t longest = 0;
  for (std::size_t i = 1; i + 1 < shares.size(); ++i)
    if (shares[i + 1] - shares[i] > shares[longest + 1] - shares[longest]) longest = i;
  const Point middle = from + 0.5 * (shares[longest] + shares[longest + 1]) * (to - from);
  const bool longest_is_free = inside(number, middle) == ring.field;
  double through_m = 0, further_m = 0;
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    const bool as_longest = (i % 2 == 0) == (longest % 2 == 0);
    if (as_longest == longest_is_free) continue;
    const double begin = i == 0 ? nearest_along_m(ring, from) : crossed[i - 1].along_m;
    const double end = i == crossed.size() ? nearest_along_m(ring, to) : crossed[i].along_m;
    const double one_way = std::abs(end - begin);
    const double edge_m = std::min(one_way, ring.along_m.back() - one_way);
    const double straight_m = (shares[i + 1] - shares[i]) * hop.length_m;
    through_m += straight_m;
    further_m += std::max(0.0, edge_m - straight_m);
  }
  hop.way_round_m += further_m;
  const bool through = through_m > kTouchesObstacle_m && further_m > kAlongSide_share * through_m;
  if (ring.field ? further_m > far_m_ : through) hop.barred = true;
}

Hop HopGround::hop(Point from, Point to) const {
  Hop out;
  out.length_m = out.way_round_m = distance(from, to);
  if (out.length_m <= 2 * kAtEdge_m) return out;
  const std::vector<EdgeCrossing> crossed = edge_crossings(from, to);
  const Box box = bounds(from, to);
  auto next = crossed.begin();
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const auto first = next;
    while (next != crossed.end() && next->ring == i) ++next;
    if (first == next && !intersects(rings_[i].box, box) && !rings_[i].field) continue;
    lead_round(i, {first, next}, from, to, out);
  }
  return out;
}

}  // namespace tramline::order
