#include "tramline/coverage/snapped_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "tramline/coverage/tile_frame.h"

namespace tramline::coverage {
namespace {

/// Half a coarse unit, and what rounding may have moved.
constexpr std::int64_t kReach = kCoarse / 2 + 16;

TilePoint coarse(TilePoint p) {
  return {(p.x + static_cast<std::int32_t>(kCoarse / 2)) >> kCoarseShift,
          (p.y + static_cast<std::int32_t>(kCoarse / 2)) >> kCoarseShift};
}
TilePoint fine(TilePoint p) { return {p.x << kCoarseShift, p.y << kCoarseShift}; }

/// Coarse points in square buckets.
class PointGrid {
 public:
  PointGrid(std::vector<TilePoint> points, std::int64_t side) : points_(std::move(points)) {
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    constexpr double kMostBuckets = 256;
    buckets_ = static_cast<std::int64_t>(
        std::clamp(std::sqrt(static_cast<double>(points_.size())), 1.0, kMostBuckets));
    width_ = side / buckets_ + 1;
    first_.assign(static_cast<std::size_t>(buckets_ * buckets_) + 2, 0);
    for (const TilePoint p : points_) ++first_[bucket_of(p) + 2];
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<TilePoint> sorted(points_.size());
    for (const TilePoint p : points_) sorted[first_[bucket_of(p) + 1]++] = p;
    points_ = std::move(sorted);
  }

  /// Calls `visit` for every point whose square the edge may pass. Fine coordinates of the edge.
  template <class Visit>
  void each_near(const TileEdge& edge, Visit visit) const {
    const std::int64_t ax = std::min(edge.from.x, edge.to.x), bx = std::max(edge.from.x, edge.to.x);
    const auto dx = static_cast<double>(edge.to.x) - edge.from.x;
    const double slope = dx != 0 ? (static_cast<double>(edge.to.y) - edge.from.y) / dx : 0;
    for (std::int64_t column = place(ax - kReach); column <= place(bx + kReach); ++column) {
      std::int64_t low = std::min(edge.from.y, edge.to.y), high = std::max(edge.from.y, edge.to.y);
      if (dx != 0) {
        // The stretch of the edge within the column, by one more unit for rounding.
        const auto west = static_cast<double>(std::max(ax, column * width_ - 2 * kReach));
        const auto east = static_cast<double>(std::min(bx, (column + 1) * width_ + 2 * kReach));
        const double y1 = edge.from.y + slope * (west - edge.from.x);
        const double y2 = edge.from.y + slope * (east - edge.from.x);
        low = std::max(low, static_cast<std::int64_t>(std::min(y1, y2)) - 1);
        high = std::min(high, static_cast<std::int64_t>(std::max(y1, y2)) + 2);
      }
      for (std::int64_t row = place(low - kReach); row <= place(high + kReach); ++row) {
        const auto bucket = static_cast<std::size_t>(column * buckets_ + row);
        for (std::size_t i = first_[bucket]; i < first_[bucket + 1]; ++i) visit(points_[i]);
      }
    }
  }

 private:
  std::int64_t place(std::int64_t coordinate) const {
    return std::clamp<std::int64_t>(coordinate / width_, 0, buckets_ - 1);
  }
  std::size_t bucket_of(TilePoint p) const {
    return static_cast<std::size_t>(place(fine(p).x) * buckets_ + place(fine(p).y));
  }

  std::vector<TilePoint> points_;
  std::vector<std::uint32_t> first_;
  std::int64_t buckets_ = 1;
  std::int64_t width_ = 1;
};

/// Whether the edge passes the square round a point.
bool passes(const TileEdge& edge, TilePoint centre) {
  if (centre.x < std::min(edge.from.x, edge.to.x) - kReach ||
      centre.x > std::max(edge.from.x, edge.to.x) + kReach ||
      centre.y < std::min(edge.from.y, edge.to.y) - kReach ||
      centre.y > std::max(edge.from.y, edge.to.y) + kReach)
    return false;
  const std::int64_t dx = std::abs(static_cast<std::int64_t>(edge.to.x) - edge.from.x);
  const std::int64_t dy = std::abs(static_cast<std::int64_t>(edge.to.y) - edge.from.y);
  return std::abs(turn(edge.from, edge.to, centre)) <= kReach * (dx + dy);
}

}  // namespace

EdgeSum snapped(const std::vector<TileEdge>& edges, std::int64_t side) {
  std::vector<TilePoint> ends;
  ends.reserve(2 * edges.size());
  for (const TileEdge& edge : edges) {
    ends.push_back(coarse(edge.from));
    ends.push_back(coarse(edge.to));
  }
  const PointGrid grid(std::move(ends), side);
  EdgeSum out(edges.size() + edges.size() / 2);
  std::vector<std::pair<std::int64_t, TilePoint>> between;
  for (const TileEdge& edge : edges) {
    const TilePoint from = coarse(edge.from), to = coarse(edge.to);
    if (from == to) continue;
    const std::int64_t dx = static_cast<std::int64_t>(edge.to.x) - edge.from.x;
    const std::int64_t dy = static_cast<std::int64_t>(edge.to.y) - edge.from.y;
    between.clear();
    grid.each_near(edge, [&](TilePoint p) {
      const TilePoint at = fine(p);
      if (p == from || p == to || !passes(edge, at)) return;
      const std::int64_t along = dx * (static_cast<std::int64_t>(at.x) - edge.from.x) +
                                 dy * (static_cast<std::int64_t>(at.y) - edge.from.y);
      between.emplace_back(along, p);
    });
    std::sort(between.begin(), between.end());
    TilePoint last = from;
    for (const auto& [along, p] : between) {
      out.add(last, p);
      last = p;
    }
    out.add(last, to);
  }
  return out;
}

}  // namespace tramline::coverage
