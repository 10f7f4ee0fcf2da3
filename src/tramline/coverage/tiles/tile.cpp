#include "tramline/coverage/tiles/tile.h"

#include <algorithm>

namespace tramline::coverage {
namespace {

/// Calls `visit(cell)` for the cells in these states whose box the piece's meets, but not for those that are
/// added meanwhile. Stops when it returns true, and says so.
template <class Visit>
bool any_near(const TilePiece& piece, StateSet states, const CellStore& cells, Visit visit) {
  const std::size_t count = cells.size();
  for (std::size_t first = 0; first < count; first += CellStore::kBlock) {
    if (!cells.block_box(first / CellStore::kBlock).meets(piece.box)) continue;
    const std::size_t end = std::min(first + CellStore::kBlock, count);
    for (std::size_t c = first; c < end; ++c)
      if (holds(states, cells.state(c)) && cells.box(c).meets(piece.box) && visit(c)) return true;
  }
  return false;
}

enum class Overlap { kNone, kCut, kWithin };

/// How the piece meets a cell, judged line by line; fills scratch.cutting.
Overlap overlap_of(const TilePiece& piece, std::span<const TilePoint> ring, CutScratch& scratch) {
  scratch.cutting.assign(piece.lines.size(), 0);
  bool cut = false;
  for (std::size_t k = 0; k < piece.lines.size(); ++k) {
    double least = piece.lines[k].inside(ring[0]), most = least;
    for (std::size_t i = 1; i < ring.size(); ++i) {
      const double d = piece.lines[k].inside(ring[i]);
      least = std::min(least, d);
      most = std::max(most, d);
    }
    if (most <= kOnLine) return Overlap::kNone;
    if (least < -kOnLine) {
      scratch.cutting[k] = 1;
      cut = true;
    }
  }
  return cut ? Overlap::kCut : Overlap::kWithin;
}

/// Cuts a cell by the lines that scratch.cutting names: scratch.inside, and `parts` rings of
/// scratch.outside. Returns false where nothing is left inside.
bool cut(const TilePiece& piece, std::span<const TilePoint> cell, std::int64_t side, CutScratch& scratch,
         std::size_t& parts) {
  parts = 0;
  scratch.inside.assign(cell.begin(), cell.end());
  for (std::size_t k = 0; k < piece.lines.size(); ++k) {
    if (scratch.cutting[k] == 0) continue;
    const TileLine& line = piece.lines[k];
    scratch.ring.swap(scratch.inside);
    scratch.distance.clear();
    double least = 0, most = 0;
    for (const TilePoint p : scratch.ring) {
      const double d = line.inside(p);
      least = std::min(least, d);
      most = std::max(most, d);
      scratch.distance.push_back(d);
    }
    if (most <= kOnLine) return false;
    if (least >= -kOnLine) {
      scratch.ring.swap(scratch.inside);
      continue;
    }
    if (parts == scratch.outside.size()) scratch.outside.emplace_back();
    split(scratch.ring, scratch.distance, line, side, scratch.inside, scratch.outside[parts]);
    if (scratch.inside.empty()) return false;
    if (!scratch.outside[parts].empty()) ++parts;
  }
  return true;
}

}  // namespace

bool apply(const TilePiece& piece, const Transition& next, StateSet changing, std::int64_t side, Tile& tile,
           Totals& totals, CutScratch& scratch) {
  bool changed = false;
  CellStore& cells = tile.cells;
  any_near(piece, changing, cells, [&](std::size_t c) {
    const std::span<const TilePoint> ring = cells.ring(c);
    const Overlap overlap = overlap_of(piece, ring, scratch);
    if (overlap == Overlap::kNone) return false;
    std::size_t parts = 0;
    if (overlap == Overlap::kCut && !cut(piece, ring, side, scratch, parts)) return false;
    const CellState before = cells.state(c), after = next[before];
    const std::int64_t whole = twice_area(ring.data(), ring.size());
    changed = true;
    totals[before] -= whole;
    if (overlap == Overlap::kWithin) {
      totals[after] += whole;
      cells.set_state(c, after);
      return false;
    }
    totals[after] += twice_area(scratch.inside);
    cells.replace(c, scratch.inside, after);
    for (std::size_t i = 0; i < parts; ++i) {
      totals[before] += twice_area(scratch.outside[i]);
      cells.add(scratch.outside[i], before);
    }
    return false;
  });
  return changed;
}

bool covers(const TilePiece& piece, StateSet states, std::int64_t side, const Tile& tile,
            CutScratch& scratch) {
  return any_near(piece, states, tile.cells, [&](std::size_t c) {
    const std::span<const TilePoint> ring = tile.cells.ring(c);
    const Overlap overlap = overlap_of(piece, ring, scratch);
    std::size_t parts = 0;
    return overlap == Overlap::kWithin ||
           (overlap == Overlap::kCut && cut(piece, ring, side, scratch, parts));
  });
}

void add_areas(const CellStore& cells, Totals& totals) {
  for (std::size_t c = 0; c < cells.size(); ++c)
    totals[cells.state(c)] += twice_area(cells.ring(c).data(), cells.ring(c).size());
}

}  // namespace tramline::coverage
