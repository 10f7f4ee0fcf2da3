#include "tramline/coverage/tiles/tile_coverage.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "tramline/coverage/tiles/assemble_rings.h"
#include "tramline/coverage/tiles/merge_cells.h"
#include "tramline/coverage/tiles/quad_pieces.h"
#include "tramline/coverage/tiles/recent_swath.h"
#include "tramline/coverage/tiles/tile_map.h"
#include "tramline/coverage/tiles/tiles_reached.h"
#include "tramline/coverage/tiles/untouched_ground.h"
#include "tramline/model/limits.h"

namespace tramline::coverage {
namespace {

/// Tiles into which a piece reaches no further than this are left alone.
constexpr auto kTouch = static_cast<std::int64_t>(kOnLine);

template <class Visit>
void each_tile_of(const ConvexPiece& piece, const TileFrame& frame, Visit visit) {
  each_tile_reached(
      frame, piece.sides.size(), [&](std::size_t i) { return piece.sides[i].from; }, -kTouch, visit);
}

/// States of ground that may become repeated: worked, but not repeated yet.
StateSet once_worked() { return changed_by(made_repeated()); }

}  // namespace

struct TileCoverage::Impl {
  Impl(const Region& region, const Settings& wanted)
      : settings(wanted), frame(tile_frame(wanted.tile_m)), field(region, frame) {
    sum_up();
  }

  void mark_repeated(const WorkedStep& step);
  bool meets_worked(const ConvexPiece& piece);
  void work(const ConvexPiece& piece, const Transition& next);
  void sum_up();
  Region region(LandClass what) const;
  void append_open(const TilePiece& piece, TileIndex index, const CellStore& cells,
                   std::vector<Ring>& out) const;

  Settings settings;
  TileFrame frame;
  FieldCells field;
  TileMap map;
  RecentSwaths trails;
  Totals totals{};
  Int128 gross = 0;
  CoverageAreas areas;
  std::uint64_t stamp = 0;
  bool changed = false;
  const Transition repeat = made_repeated();
  const Transition count = worked_again(settings.multiplicity ? kMostCounted : 2);

  std::vector<ConvexPiece> pieces;  ///< of the step
  TilePiece seen;
  CutScratch scratch;
  MergeMemory merging;
};

bool TileCoverage::Impl::meets_worked(const ConvexPiece& piece) {
  bool met = false;
  each_tile_of(piece, frame, [&](TileIndex index) {
    const Tile* tile = met ? nullptr : map.find(index);
    if (tile == nullptr) return;
    see(piece, frame.corner(index), frame.side, seen);
    met = covers(seen, once_worked(), frame.side, *tile, scratch);
  });
  return met;
}

void TileCoverage::Impl::work(const ConvexPiece& piece, const Transition& next) {
  const StateSet changing = changed_by(next);
  each_tile_of(piece, frame, [&](TileIndex index) {
    Tile& tile = map.at(index, field, scratch);
    see(piece, frame.corner(index), frame.side, seen);
    if (!apply(seen, next, changing, frame.side, tile, totals, scratch)) return;
    tile.changed = stamp + 1;
    changed = true;
    merge_when_due(tile, totals, merging);
  });
}

/// Before anything of the step is counted, so that its quads do not repeat one another.
void TileCoverage::Impl::mark_repeated(const WorkedStep& step) {
  for (const ConvexPiece& piece : pieces) {
    if (!meets_worked(piece)) continue;
    for (const ConvexPiece& part : trails.outside(piece, step.run, step.travel_m - step.reach_m))
      work(part, repeat);
  }
}

void TileCoverage::Impl::sum_up() {
  Int128 covered = 0, inside = 0, repeated = 0, sliver = 0, unrecorded = 0;
  std::array<Int128, kMostCounted + 1> times{};
  for (CellState s = 0; s < kCellStates; ++s) {
    times[static_cast<std::size_t>(times_worked(s))] += totals[s];
    if (is_unrecorded(s)) unrecorded += totals[s];
    if (times_worked(s) == 0) continue;
    covered += totals[s];
    if (in_field(s)) inside += totals[s];
    if (is_repeated(s)) repeated += totals[s];
    if (!is_repeated(s) && times_worked(s) > 1) sliver += totals[s];
  }
  areas.gross_m2 = frame.area_m2(gross);
  areas.covered_m2 = frame.area_m2(covered);
  areas.covered_inside_m2 = frame.area_m2(inside);
  areas.outside_m2 = frame.area_m2(covered - inside);
  areas.repeated_m2 = frame.area_m2(repeated);
  areas.sliver_m2 = frame.area_m2(sliver);
  // Rounding along the boundary may make the field's cells a little larger than the field.
  const Int128 not_covered = std::max<Int128>(field.twice_area() - inside, 0);
  if (field.twice_area() > 0) unrecorded = std::min(unrecorded, not_covered);
  areas.missed_m2 = frame.area_m2(field.twice_area() > 0 ? not_covered - unrecorded : 0);
  areas.not_recorded_m2 = frame.area_m2(unrecorded);
  areas.worked_times_m2.fill(std::numeric_limits<double>::quiet_NaN());
  if (!settings.multiplicity) return;
  areas.worked_times_m2[0] = frame.area_m2(not_covered);
  for (std::size_t n = 1; n < times.size(); ++n) areas.worked_times_m2[n] = frame.area_m2(times[n]);
}

Region TileCoverage::Impl::region(LandClass what) const {
  std::vector<const Tile*> tiles;
  for (const Tile& tile : map.tiles()) tiles.push_back(&tile);
  std::sort(tiles.begin(), tiles.end(), [](const Tile* a, const Tile* b) { return a->index < b->index; });
  UntouchedGround untouched;
  if (what == LandClass::kMissed) {
    std::vector<TileIndex> touched;
    for (const Tile* tile : tiles) touched.push_back(tile->index);
    untouched = untouched_ground(field, touched, frame);
  }
  const StateSet states = states_of(what);
  std::vector<TileOutline> outlines(tiles.size() + untouched.border_tiles.size());
  tbb::parallel_for(std::size_t{0}, outlines.size(), [&](std::size_t i) {
    if (i < tiles.size()) {
      outlines[i] = outline_of(tiles[i]->index, tiles[i]->cells, states, frame.side);
      return;
    }
    const TileIndex index = untouched.border_tiles[i - tiles.size()];
    CellStore cells;
    CutScratch memory;
    field.partition(index, cells, memory);
    outlines[i] = outline_of(index, cells, states, frame.side);
  });
  return assembled(outlines, std::move(untouched.border), frame);
}

void TileCoverage::Impl::append_open(const TilePiece& piece, TileIndex index, const CellStore& cells,
                                     std::vector<Ring>& out) const {
  const GridPoint corner = frame.corner(index);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const CellState state = cells.state(cell);
    const bool open = times_worked(state) == 0 && (in_field(state) || field.twice_area() == 0);
    if (!open || !cells.box(cell).meets(piece.box)) continue;
    Ring& ring = out.emplace_back();
    for (const TilePoint p : cells.ring(cell))
      ring.push_back({static_cast<double>(corner.x + p.x) * frame.unit_m,
                      static_cast<double>(corner.y + p.y) * frame.unit_m});
  }
}

TileCoverage::TileCoverage(const Region& field, const Settings& settings)
    : impl_(std::make_unique<Impl>(field, settings)) {}
TileCoverage::TileCoverage(TileCoverage&&) noexcept = default;
TileCoverage& TileCoverage::operator=(TileCoverage&&) noexcept = default;
TileCoverage::~TileCoverage() = default;

void TileCoverage::add(const WorkedStep& step) {
  assert(std::all_of(step.quads.begin(), step.quads.end(), [](const Quad& quad) {
    return std::all_of(quad.begin(), quad.end(),
                       [](Point p) { return std::abs(p.x) <= kFarthest_m && std::abs(p.y) <= kFarthest_m; });
  }));
  Impl& impl = *impl_;
  impl.pieces.clear();
  impl.changed = false;
  for (const Quad& quad : step.quads) append_pieces(quad, impl.frame, impl.pieces);
  impl.mark_repeated(step);
  for (const ConvexPiece& piece : impl.pieces) {
    impl.gross += twice_area(piece);
    impl.work(piece, impl.count);
    impl.trails.add(step.run, step.travel_m, piece);
  }
  if (impl.changed) ++impl.stamp;
  impl.sum_up();
}

void TileCoverage::add_unrecorded(const std::vector<Quad>& quads) {
  if (quads.empty()) return;
  Impl& impl = *impl_;
  impl.pieces.clear();
  impl.changed = false;
  for (const Quad& quad : quads) append_pieces(quad, impl.frame, impl.pieces);
  // Without a field all ground may have been meant.
  const Transition unrecorded = impl.field.twice_area() == 0 ? made_unrecorded() : made_unrecorded_in_field();
  for (const ConvexPiece& piece : impl.pieces) impl.work(piece, unrecorded);
  if (impl.changed) ++impl.stamp;
  impl.sum_up();
}

const CoverageAreas& TileCoverage::areas() const { return impl_->areas; }

Region TileCoverage::region(LandClass what) const {
  if (!impl_->settings.multiplicity && (what == LandClass::kTwice || what == LandClass::kOften)) return {};
  return impl_->region(what);
}

std::vector<Ring> TileCoverage::open_ground(const Ring& convex) const {
  const Impl& impl = *impl_;
  std::vector<GridPoint> corners;
  for (const Point p : convex) corners.push_back(impl.frame.rounded(p));
  const ConvexPiece piece = piece_of(corners);
  std::vector<Ring> out;
  TilePiece seen;
  each_tile_reached(
      impl.frame, corners.size(), [&](std::size_t i) { return corners[i]; }, 0,
      [&](TileIndex index) {
        see(piece, impl.frame.corner(index), impl.frame.side, seen);
        if (const Tile* tile = impl.map.find(index)) return impl.append_open(seen, index, tile->cells, out);
        CellStore untouched;
        CutScratch memory;
        impl.field.partition(index, untouched, memory);
        impl.append_open(seen, index, untouched, out);
      });
  return out;
}

std::vector<TileCoverage::Change> TileCoverage::changes_since(std::uint64_t stamp, LandClass what) const {
  const TileFrame& frame = impl_->frame;
  const auto metres = [&](std::int64_t units) { return static_cast<double>(units) * frame.unit_m; };
  std::vector<const Tile*> changed;
  for (const Tile& tile : impl_->map.tiles())
    if (tile.changed > stamp) changed.push_back(&tile);
  std::vector<Change> out(changed.size());
  tbb::parallel_for(std::size_t{0}, changed.size(), [&](std::size_t i) {
    const Tile& tile = *changed[i];
    const GridPoint corner = frame.corner(tile.index);
    out[i].index = tile.index;
    out[i].tile = {metres(corner.x), metres(corner.y), metres(corner.x + frame.side),
                   metres(corner.y + frame.side)};
    out[i].ground = assembled({outline_of(tile.index, tile.cells, states_of(what), frame.side)}, {}, frame);
  });
  return out;
}

std::uint64_t TileCoverage::stamp() const { return impl_->stamp; }

TileCoverage::Size TileCoverage::size() const {
  Size out;
  for (const Tile& tile : impl_->map.tiles()) {
    ++out.tiles;
    out.cells += tile.cells.size();
    out.bytes += sizeof(Tile) + tile.cells.bytes();
  }
  return out;
}

}  // namespace tramline::coverage
