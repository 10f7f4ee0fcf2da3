#include "tramline/coverage/merge_cells.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tramline::coverage {
namespace {

/// An edge of a cell, whichever way the cell walks it.
struct SharedEdge {
  TilePoint least;
  TilePoint most;
  std::uint32_t cell = 0;
  std::uint16_t place = 0;  ///< of the edge's first point within the ring

  friend bool operator<(const SharedEdge& a, const SharedEdge& b) {
    return std::tie(a.least, a.most, a.cell, a.place) < std::tie(b.least, b.most, b.cell, b.place);
  }
};

/// Cells with more corners than this do not come from merging: every piece that comes near looks at all.
constexpr std::size_t kMostCorners = 24;

enum class Bend { kLeft, kStraight, kRight };

Bend bend(TilePoint before, TilePoint at, TilePoint after) {
  const auto size = static_cast<double>(turn(before, at, after));
  const double length =
      std::hypot(static_cast<double>(after.x) - before.x, static_cast<double>(after.y) - before.y);
  const double ahead = (static_cast<double>(at.x) - before.x) * (static_cast<double>(after.x) - at.x) +
                       (static_cast<double>(at.y) - before.y) * (static_cast<double>(after.y) - at.y);
  if (std::abs(size) <= kStraight * length && ahead > 0) return Bend::kStraight;
  return size > 0 ? Bend::kLeft : Bend::kRight;
}

TilePoint at(std::span<const TilePoint> ring, std::size_t place) { return ring[place % ring.size()]; }

/// The union of two rings that share the edge that begins at that place of either; empty where it is not
/// convex.
void unite(std::span<const TilePoint> a, std::size_t a_place, std::span<const TilePoint> b,
           std::size_t b_place, TileRing& out) {
  out.clear();
  // The edge runs p → q along a. From q round a to p, then round b back to q.
  const TilePoint p = a[a_place], q = at(a, a_place + 1);
  const Bend at_p = bend(at(a, a_place + a.size() - 1), p, at(b, b_place + 2));
  const Bend at_q = bend(at(b, b_place + b.size() - 1), q, at(a, a_place + 2));
  if (at_p == Bend::kRight || at_q == Bend::kRight) return;
  if (at_q == Bend::kLeft) out.push_back(q);
  for (std::size_t i = 2; i < a.size(); ++i) out.push_back(at(a, a_place + i));
  if (at_p == Bend::kLeft) out.push_back(p);
  for (std::size_t i = 2; i < b.size(); ++i) out.push_back(at(b, b_place + i));
  if (out.size() < 3 || out.size() > kMostCorners || twice_area(out) <= 0) out.clear();
}

void collect(const CellStore& cells, const std::vector<bool>& kept, std::vector<SharedEdge>& out) {
  out.clear();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!kept[c]) continue;
    const std::span<const TilePoint> ring = cells.ring(c);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const TilePoint from = ring[i], to = at(ring, i + 1);
      out.push_back({std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(c),
                     static_cast<std::uint16_t>(i)});
    }
  }
  std::sort(out.begin(), out.end());
}

/// One round: every cell is merged once at most. Returns how often.
std::size_t merge_once(CellStore& cells, std::vector<bool>& kept, std::vector<SharedEdge>& edges,
                       Totals& totals) {
  collect(cells, kept, edges);
  std::vector<bool> changed(cells.size(), false);
  TileRing ring;
  std::size_t merged = 0;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const SharedEdge &one = edges[i], &other = edges[i + 1];
    if (one.least != other.least || one.most != other.most) continue;
    const std::size_t a = one.cell, b = other.cell;
    if (a == b || changed[a] || changed[b] || cells.state(a) != cells.state(b)) continue;
    const std::span<const TilePoint> a_ring = cells.ring(a), b_ring = cells.ring(b);
    if (a_ring[one.place] == b_ring[other.place]) continue;
    unite(a_ring, one.place, b_ring, other.place, ring);
    if (ring.empty()) continue;
    const CellState state = cells.state(a);
    totals[state] += twice_area(ring) - twice_area(a_ring.data(), a_ring.size()) -
                     twice_area(b_ring.data(), b_ring.size());
    cells.replace(a, ring, state);
    kept[b] = false;
    changed[a] = changed[b] = true;
    ++merged;
  }
  return merged;
}

constexpr std::size_t kFewCells = 64;

}  // namespace

void merge_cells(Tile& tile, Totals& totals) {
  std::vector<bool> kept(tile.cells.size(), true);
  std::vector<SharedEdge> edges;
  std::size_t merged = 0;
  while (const std::size_t now = merge_once(tile.cells, kept, edges, totals)) merged += now;
  if (merged > 0) tile.cells.keep(kept);
}

void merge_when_due(Tile& tile, Totals& totals) {
  if (tile.cells.size() < std::max(tile.merge_at, kFewCells)) return;
  merge_cells(tile, totals);
  tile.merge_at = std::max(2 * tile.cells.size(), kFewCells);
}

}  // namespace tramline::coverage
