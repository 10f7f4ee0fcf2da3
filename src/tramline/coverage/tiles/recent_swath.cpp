#include "tramline/coverage/tiles/recent_swath.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "tramline/coverage/tiles/tile_frame.h"

namespace tramline::coverage {
namespace {

constexpr std::size_t kMostPieces = std::size_t{1} << 18;

double squared(GridPoint a, GridPoint b) {
  const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
  return dx * dx + dy * dy;
}

bool within(const ConvexPiece& piece, const GridLine& line) {
  return std::all_of(piece.sides.begin(), piece.sides.end(),
                     [&](const ConvexPiece::Side& side) { return line.inside(side.from) >= -kOnLine; });
}

bool beyond(const ConvexPiece& piece, const GridLine& line) {
  return std::all_of(piece.sides.begin(), piece.sides.end(),
                     [&](const ConvexPiece::Side& side) { return line.inside(side.from) <= kOnLine; });
}

/// What is left of the piece outside a convex ring of `count` corners; appended to `out`.
void subtract(const ConvexPiece& piece, const GridPoint* corners, std::size_t count,
              std::vector<ConvexPiece>& out) {
  std::array<GridLine, 4> lines;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  for (std::size_t i = 0; i < count; ++i) lines[i] = line_through(corners[i], corners[(i + 1) % count]);
  for (std::size_t i = 0; i < count; ++i)
    if (beyond(piece, lines[i])) return out.push_back(piece);
  // Long sides first, as when tiles are cut.
  std::stable_sort(
      order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), [&](std::size_t a, std::size_t b) {
        return squared(corners[a], corners[(a + 1) % count]) > squared(corners[b], corners[(b + 1) % count]);
      });
  const std::size_t before = out.size();
  ConvexPiece rest = piece, inside, outside;
  for (std::size_t k = 0; k < count; ++k) {
    const GridLine& line = lines[order[k]];
    if (within(rest, line)) continue;
    split(rest, line, inside, outside);
    if (inside.empty()) {  // they do not meet after all
      out.resize(before);
      return out.push_back(piece);
    }
    if (!outside.empty()) out.push_back(outside);
    rest = std::move(inside);
  }
}

}  // namespace

RecentSwaths::Octagon::Octagon(GridPoint p) : least{p.x, p.y, p.x + p.y, p.x - p.y}, most(least) {}

void RecentSwaths::Octagon::extend(GridPoint p) {
  const std::array<std::int64_t, 4> along{p.x, p.y, p.x + p.y, p.x - p.y};
  for (std::size_t i = 0; i < along.size(); ++i) {
    least[i] = std::min(least[i], along[i]);
    most[i] = std::max(most[i], along[i]);
  }
}

bool RecentSwaths::Octagon::apart(const Octagon& other) const {
  for (std::size_t i = 0; i < least.size(); ++i)
    if (least[i] > other.most[i] || other.least[i] > most[i]) return true;
  return false;
}

void RecentSwaths::add(int run, double travel_m, const ConvexPiece& piece) {
  assert(piece.sides.size() == 3 || piece.sides.size() == 4);
  Trail& trail = trails_[run];
  trail.used = ++uses_;
  Worked worked;
  worked.travel_m = travel_m;
  worked.count = static_cast<std::uint8_t>(std::min(piece.sides.size(), worked.corners.size()));
  for (std::size_t i = 0; i < worked.count; ++i) worked.corners[i] = piece.sides[i].from;
  pieces_ -= trail.pieces.size() - trail.first;
  forget_before(trail, travel_m - kLongestReach_m);
  if (trail.pieces.size() % kBlock == 0) trail.blocks.emplace_back(worked.corners[0]);
  for (std::size_t i = 0; i < worked.count; ++i) trail.blocks.back().extend(worked.corners[i]);
  trail.pieces.push_back(worked);
  pieces_ += trail.pieces.size() - trail.first;
  if (pieces_ > kMostPieces) forget_oldest(run);
}

void RecentSwaths::forget_before(Trail& trail, double travel_m) {
  while (trail.first < trail.pieces.size() && trail.pieces[trail.first].travel_m < travel_m) ++trail.first;
  if (2 * trail.first <= trail.pieces.size()) return;
  const auto blocks = static_cast<std::ptrdiff_t>(trail.first / kBlock);
  const auto pieces = blocks * static_cast<std::ptrdiff_t>(kBlock);
  trail.blocks.erase(trail.blocks.begin(), trail.blocks.begin() + blocks);
  trail.pieces.erase(trail.pieces.begin(), trail.pieces.begin() + pieces);
  trail.first -= static_cast<std::size_t>(pieces);
}

void RecentSwaths::forget_oldest(int but) {
  std::vector<std::pair<std::uint64_t, int>> by_use;
  for (const auto& [run, trail] : trails_)
    if (run != but) by_use.emplace_back(trail.used, run);
  std::sort(by_use.begin(), by_use.end());
  for (const auto& [used, run] : by_use) {
    if (2 * pieces_ <= kMostPieces) return;
    const Trail& trail = trails_[run];
    pieces_ -= trail.pieces.size() - trail.first;
    trails_.erase(run);
  }
}

bool RecentSwaths::apart(const ConvexPiece& piece, const Worked& worked, std::size_t& apart_by) {
  // On a straight way the same side parts the piece from all before it.
  for (std::size_t k = 0; k < piece.sides.size(); ++k) {
    const std::size_t side = (apart_by + k) % piece.sides.size();
    bool out = true;
    for (std::size_t i = 0; i < worked.count && out; ++i)
      out = piece.sides[side].line.inside(worked.corners[i]) <= kOnLine;
    if (!out) continue;
    apart_by = side;
    return true;
  }
  return false;
}

std::vector<ConvexPiece> RecentSwaths::outside(const ConvexPiece& piece, int run, double since_m) const {
  std::vector<ConvexPiece> out{piece}, next;
  const auto found = trails_.find(run);
  if (found == trails_.end()) return out;
  const Trail& trail = found->second;
  Octagon round(piece.sides[0].from);
  for (const ConvexPiece::Side& side : piece.sides) round.extend(side.from);
  std::size_t apart_by = 0;
  for (std::size_t i = trail.pieces.size(); i > trail.first && !out.empty();) {
    // The newest pieces first: most likely they cover it.
    const Worked& worked = trail.pieces[i - 1];
    if (worked.travel_m < since_m) break;
    if (trail.blocks[(i - 1) / kBlock].apart(round)) {
      i = (i - 1) / kBlock * kBlock;
      continue;
    }
    --i;
    if (apart(piece, worked, apart_by)) continue;
    next.clear();
    for (const ConvexPiece& part : out) subtract(part, worked.corners.data(), worked.count, next);
    out.swap(next);
  }
  return out;
}

}  // namespace tramline::coverage
