#include "tramline/coverage/tiles/snapped_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace tramline::coverage {
namespace {

std::int32_t off_border(std::int32_t coordinate, std::int32_t side) {
  if (coordinate <= kSnap) return 0;
  return coordinate >= side - kSnap ? side : coordinate;
}

bool is_near(TilePoint a, TilePoint b) {
  const auto dx = static_cast<double>(a.x) - b.x, dy = static_cast<double>(a.y) - b.y;
  return dx * dx + dy * dy <= static_cast<double>(kSnap) * kSnap;
}

std::vector<TilePoint> ends_of(const std::vector<TileEdge>& edges) {
  std::vector<TilePoint> out;
  out.reserve(2 * edges.size());
  for (const TileEdge& edge : edges) {
    out.push_back(edge.from);
    out.push_back(edge.to);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// For each of the points (ascending) the one that stands for it and all that lie close.
class Clusters {
 public:
  Clusters(const std::vector<TilePoint>& points, std::int32_t side) : points_(points), head_(points.size()) {
    std::iota(head_.begin(), head_.end(), std::size_t{0});
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size() && points[j].x - points[i].x <= kSnap; ++j)
        if (is_near(points[i], points[j])) join(i, j, side);
  }

  bool any() const { return any_; }
  TilePoint of(TilePoint p) {
    const auto at = std::lower_bound(points_.begin(), points_.end(), p);
    return points_[head(static_cast<std::size_t>(at - points_.begin()))];
  }

 private:
  std::size_t head(std::size_t i) {
    while (head_[i] != i) i = head_[i] = head_[head_[i]];
    return i;
  }
  /// Points on the border stay there, corners above all.
  void join(std::size_t i, std::size_t j, std::int32_t side) {
    const auto rank = [&](std::size_t n) {
      const TilePoint p = points_[n];
      const int borders = (p.x == 0 || p.x == side ? 1 : 0) + (p.y == 0 || p.y == side ? 1 : 0);
      return std::pair(-borders, n);
    };
    any_ = true;
    i = head(i);
    j = head(j);
    if (rank(j) < rank(i)) std::swap(i, j);
    head_[j] = i;
  }

  const std::vector<TilePoint>& points_;
  std::vector<std::size_t> head_;
  bool any_ = false;
};

/// Points in square buckets.
class PointGrid {
 public:
  PointGrid(std::vector<TilePoint> points, std::int32_t side) : points_(std::move(points)) {
    constexpr double kMostBuckets = 256;
    buckets_ = static_cast<std::int32_t>(
        std::clamp(std::sqrt(static_cast<double>(points_.size())), 1.0, kMostBuckets));
    width_ = side / buckets_ + 1;
    first_.assign(static_cast<std::size_t>(buckets_) * static_cast<std::size_t>(buckets_) + 2, 0);
    for (const TilePoint p : points_) ++first_[bucket_of(p) + 2];
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<TilePoint> sorted(points_.size());
    for (const TilePoint p : points_) sorted[first_[bucket_of(p) + 1]++] = p;
    points_ = std::move(sorted);
  }

  /// Calls `visit` for every point that the edge may pass.
  template <class Visit>
  void each_near(const TileEdge& edge, Visit visit) const {
    const std::int32_t ax = std::min(edge.from.x, edge.to.x), bx = std::max(edge.from.x, edge.to.x);
    const auto dx = static_cast<double>(edge.to.x) - edge.from.x;
    const double slope = dx != 0 ? (static_cast<double>(edge.to.y) - edge.from.y) / dx : 0;
    const std::int32_t last = place(bx + kSnap);
    for (std::int32_t column = place(ax - kSnap); column <= last; ++column) {
      double low = std::min(edge.from.y, edge.to.y), high = std::max(edge.from.y, edge.to.y);
      if (dx != 0) {
        // Only the stretch of the edge within the column.
        const double west = std::max<double>(ax, static_cast<double>(column) * width_ - 2 * kSnap);
        const double east = std::min<double>(bx, (column + 1.0) * width_ + 2 * kSnap);
        const double y1 = edge.from.y + slope * (west - edge.from.x);
        const double y2 = edge.from.y + slope * (east - edge.from.x);
        low = std::max(low, std::min(y1, y2));
        high = std::min(high, std::max(y1, y2));
      }
      const std::int32_t top = place(static_cast<std::int32_t>(high) + 2 * kSnap);
      for (std::int32_t row = place(static_cast<std::int32_t>(low) - 2 * kSnap); row <= top; ++row) {
        const std::size_t bucket = bucket_at(column, row);
        for (std::size_t i = first_[bucket]; i < first_[bucket + 1]; ++i) visit(points_[i]);
      }
    }
  }

 private:
  std::int32_t place(std::int32_t coordinate) const {
    return std::clamp(coordinate / width_, 0, buckets_ - 1);
  }
  std::size_t bucket_at(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(buckets_) +
           static_cast<std::size_t>(row);
  }
  std::size_t bucket_of(TilePoint p) const { return bucket_at(place(p.x), place(p.y)); }

  std::vector<TilePoint> points_;
  std::vector<std::uint32_t> first_;
  std::int32_t buckets_ = 1;
  std::int32_t width_ = 1;
};

/// Points that an edge passes, by the way to them.
using Passed = std::vector<std::pair<std::int64_t, TilePoint>>;

void find_passed(const TileEdge& edge, const PointGrid& grid, Passed& out) {
  out.clear();
  const std::int64_t dx = static_cast<std::int64_t>(edge.to.x) - edge.from.x;
  const std::int64_t dy = static_cast<std::int64_t>(edge.to.y) - edge.from.y;
  const std::int64_t whole = dx * dx + dy * dy;
  const double reach = kSnap * std::sqrt(static_cast<double>(whole));
  grid.each_near(edge, [&](TilePoint p) {
    if (p == edge.from || p == edge.to) return;
    const std::int64_t along = dx * (static_cast<std::int64_t>(p.x) - edge.from.x) +
                               dy * (static_cast<std::int64_t>(p.y) - edge.from.y);
    if (along <= 0 || along >= whole) return;
    if (std::abs(static_cast<double>(turn(edge.from, edge.to, p))) <= reach) out.emplace_back(along, p);
  });
  std::sort(out.begin(), out.end());
}

/// One round; returns whether any edge was bent.
bool snap_once(std::vector<TileEdge>& edges, std::int32_t side, EdgeSum& out) {
  std::vector<TilePoint> points = ends_of(edges);
  if (Clusters clusters(points, side); clusters.any()) {
    for (TileEdge& edge : edges) edge = {clusters.of(edge.from), clusters.of(edge.to)};
    points = ends_of(edges);
  }
  const PointGrid grid(std::move(points), side);
  Passed passed;
  bool bent = false;
  for (const TileEdge& edge : edges) {
    if (edge.from == edge.to) continue;
    find_passed(edge, grid, passed);
    TilePoint last = edge.from;
    for (const auto& [along, p] : passed) {
      bent = bent || turn(edge.from, edge.to, p) != 0;
      out.add(last, p);
      last = p;
    }
    out.add(last, edge.to);
  }
  return bent;
}

}  // namespace

EdgeSum snapped(std::vector<TileEdge> edges, std::int32_t side) {
  for (TileEdge& edge : edges)
    for (TilePoint* p : {&edge.from, &edge.to}) *p = {off_border(p->x, side), off_border(p->y, side)};
  // Edges that were bent may have come close to other points.
  constexpr int kMostRounds = 8;
  for (int round = 1;; ++round) {
    EdgeSum out(edges.size() + edges.size() / 2);
    if (!snap_once(edges, side, out) || round == kMostRounds) return out;
    edges.clear();
    out.each_remaining([&](TilePoint from, TilePoint to) { edges.push_back({from, to}); });
  }
}

}  // namespace tramline::coverage
