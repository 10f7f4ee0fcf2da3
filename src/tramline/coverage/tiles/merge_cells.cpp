#include "tramline/coverage/tiles/merge_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace tramline::coverage {
namespace {

/// Cells with more corners than this do not come from merging: every piece that comes near looks at all.
constexpr std::size_t kMostCorners = 24;

enum class Bend { kLeft, kStraight, kRight };

Bend bend(TilePoint before, TilePoint at, TilePoint after) {
  const auto size = static_cast<double>(turn(before, at, after));
  const double dx = static_cast<double>(after.x) - before.x, dy = static_cast<double>(after.y) - before.y;
  const double ahead = (static_cast<double>(at.x) - before.x) * (static_cast<double>(after.x) - at.x) +
                       (static_cast<double>(at.y) - before.y) * (static_cast<double>(after.y) - at.y);
  if (size * size <= kStraight * kStraight * (dx * dx + dy * dy) && ahead > 0) return Bend::kStraight;
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

/// One go at the cells of a tile.
class Merging {
 public:
  Merging(CellStore& cells, MergeMemory& memory, Totals& totals)
      : cells_(cells), memory_(memory), totals_(totals), table_(memory.table) {
    std::size_t edges = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) edges += cells.ring(c).size();
    // A merger makes two new edges at most.
    table_.assign(std::bit_ceil(2 * (edges + 2 * cells.size())), {});
    memory.into.resize(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      memory.into[c] = static_cast<std::uint32_t>(c);
      enter_edges(c);
    }
  }

  /// Merges what can be; true for the cells that remain.
  std::vector<bool> remaining() {
    std::vector<bool> out(cells_.size(), true);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (!out[c]) continue;
      // Neighbours with lesser numbers were tried against it. What it becomes is tried against all.
      std::size_t from = c;
      for (std::size_t other = merge_with_any(c, from); other != c; other = merge_with_any(c, from)) {
        out[other] = false;
        from = 0;
      }
    }
    return out;
  }

 private:
  using Entry = MergeMemory::Entry;

  Entry& slot(TilePoint from, TilePoint to) {
    const std::size_t mask = table_.size() - 1;
    std::size_t i = edge_hash(from, to) & mask;
    while (table_[i].used && (table_[i].from != from || table_[i].to != to)) i = (i + 1) & mask;
    return table_[i];
  }

  void enter_edges(std::size_t c) {
    const std::span<const TilePoint> ring = cells_.ring(c);
    for (std::size_t i = 0; i < ring.size(); ++i)
      slot(ring[i], at(ring, i + 1)) = {ring[i], at(ring, i + 1), static_cast<std::uint32_t>(c), true};
  }

  /// Entries are never taken out: cells that were merged lead on to what became of them.
  std::size_t standing_for(std::uint32_t c) {
    std::vector<std::uint32_t>& into = memory_.into;
    while (into[c] != c) c = into[c] = into[into[c]];
    return c;
  }

  /// Merges cell c with the first neighbour, of those from number `first` on, that it can be merged with, and
  /// returns that; c: with none.
  std::size_t merge_with_any(std::size_t c, std::size_t first) {
    const CellState state = cells_.state(c);
    const std::span<const TilePoint> ring = cells_.ring(c);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const TilePoint from = ring[i], to = at(ring, i + 1);
      const Entry& entry = slot(to, from);
      if (!entry.used) continue;
      const std::size_t other = standing_for(entry.cell);
      if (other == c || other < first || cells_.state(other) != state) continue;
      const std::span<const TilePoint> other_ring = cells_.ring(other);
      const auto found = std::find(other_ring.begin(), other_ring.end(), to);
      if (found == other_ring.end()) continue;
      const auto place = static_cast<std::size_t>(found - other_ring.begin());
      if (at(other_ring, place + 1) != from) continue;
      unite(ring, i, other_ring, place, memory_.ring);
      if (memory_.ring.empty()) continue;
      totals_[state] += twice_area(memory_.ring) - twice_area(ring.data(), ring.size()) -
                        twice_area(other_ring.data(), other_ring.size());
      cells_.replace(c, memory_.ring, state);
      memory_.into[other] = static_cast<std::uint32_t>(c);
      enter_edges(c);
      return other;
    }
    return c;
  }

  CellStore& cells_;
  MergeMemory& memory_;
  Totals& totals_;
  std::vector<Entry>& table_;
};

constexpr std::size_t kFewCells = 64;

}  // namespace

void merge_cells(Tile& tile, Totals& totals, MergeMemory& memory) {
  const std::vector<bool> remaining = Merging(tile.cells, memory, totals).remaining();
  if (std::find(remaining.begin(), remaining.end(), false) != remaining.end()) tile.cells.keep(remaining);
  tile.merge_at = std::max(2 * tile.cells.size(), kFewCells);
}

void merge_when_due(Tile& tile, Totals& totals, MergeMemory& memory) {
  if (tile.cells.size() >= std::max(tile.merge_at, kFewCells)) merge_cells(tile, totals, memory);
}

}  // namespace tramline::coverage
