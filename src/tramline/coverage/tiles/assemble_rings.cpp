#include "tramline/coverage/tiles/assemble_rings.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "tramline/coverage/tiles/nest_holes.h"

namespace tramline::coverage {
namespace {

/// A stretch of boundary that forks nowhere but at its ends, in units.
struct Chain {
  GridPoint from;
  GridPoint to;
  GridPoint second;  ///< the point after the first
  GridPoint last_but_one;
  const TilePoint* points = nullptr;  ///< nullptr: there are none but the two ends
  std::size_t count = 0;
  GridPoint corner;  ///< of its tile
};

GridPoint placed(TilePoint p, GridPoint corner) { return {corner.x + p.x, corner.y + p.y}; }

void append_chains(const TileOutline& outline, std::int64_t side, std::vector<Chain>& out) {
  const GridPoint corner{outline.tile.column * side, outline.tile.row * side};
  std::size_t first = 0;
  for (const std::uint32_t end : outline.ends) {
    const TilePoint* points = outline.points.data() + first;
    const std::size_t count = end - first;
    out.push_back({placed(points[0], corner), placed(points[count - 1], corner), placed(points[1], corner),
                   placed(points[count - 2], corner), points, count, corner});
    first = end;
  }
}

struct BorderEvent {
  bool upright = false;
  std::int32_t line = 0;
  std::int64_t at = 0;
  int change = 0;

  friend bool operator<(const BorderEvent& a, const BorderEvent& b) {
    return std::tie(a.upright, a.line, a.at) < std::tie(b.upright, b.line, b.at);
  }
};

/// What is left of the boundary along the borders of tiles: one chain between any two places where anything
/// ends.
void append_border(const std::vector<BorderEdge>& edges, std::int64_t side, std::vector<Chain>& out) {
  std::vector<BorderEvent> events;
  const auto add = [&](bool upright, std::int32_t line, std::int64_t at, int change) {
    events.push_back({upright, line, at, change});
    // At the corner of a tile the line across is met too.
    if (at % side == 0) events.push_back({!upright, static_cast<std::int32_t>(at / side), line * side, 0});
  };
  for (const BorderEdge& edge : edges) {
    const int up = edge.to > edge.from ? 1 : edge.to < edge.from ? -1 : 0;
    add(edge.upright, edge.line, std::min(edge.from, edge.to), up);
    if (up != 0) add(edge.upright, edge.line, std::max(edge.from, edge.to), -up);
  }
  std::sort(events.begin(), events.end());
  int net = 0;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    const BorderEvent &here = events[i], &next = events[i + 1];
    net += here.change;
    if (net == 0 || here.at == next.at || here.upright != next.upright || here.line != next.line) continue;
    const auto point = [&](std::int64_t at) {
      return here.upright ? GridPoint{here.line * side, at} : GridPoint{at, here.line * side};
    };
    GridPoint from = point(here.at), to = point(next.at);
    if (net < 0) std::swap(from, to);
    for (int n = std::abs(net); n > 0; --n) out.push_back({from, to, to, from, nullptr, 2, {}});
  }
}

/// Order of directions clockwise from `back`; `back` itself comes last.
struct ClockwiseFrom {
  GridPoint back;

  static Int128 cross(GridPoint a, GridPoint b) {
    return static_cast<Int128>(a.x) * b.y - static_cast<Int128>(a.y) * b.x;
  }
  static Int128 dot(GridPoint a, GridPoint b) {
    return static_cast<Int128>(a.x) * b.x + static_cast<Int128>(a.y) * b.y;
  }
  int half(GridPoint d) const {
    const Int128 side = cross(back, d);
    if (side != 0) return side < 0 ? 0 : 2;
    return dot(back, d) < 0 ? 1 : 3;
  }
  bool operator()(GridPoint a, GridPoint b) const {
    const int half_a = half(a), half_b = half(b);
    return half_a != half_b ? half_a < half_b : cross(a, b) < 0;
  }
};

GridPoint less(GridPoint a, GridPoint b) { return {a.x - b.x, a.y - b.y}; }

struct PointHash {
  std::size_t operator()(GridPoint p) const {
    const auto x = static_cast<std::uint64_t>(p.x), y = static_cast<std::uint64_t>(p.y);
    return static_cast<std::size_t>((x * 0x9E3779B97F4A7C15ULL ^ y) * 0xBF58476D1CE4E5B9ULL >> 17);
  }
};

/// Walks along chains, ground on the left.
class ChainWalk {
 public:
  explicit ChainWalk(std::vector<Chain> chains) : chains_(std::move(chains)), used_(chains_.size(), false) {
    std::sort(chains_.begin(), chains_.end(), [](const Chain& a, const Chain& b) {
      return std::tie(a.from, a.second, a.to, a.count) < std::tie(b.from, b.second, b.to, b.count);
    });
  }

  std::vector<GridRing> rings() {
    std::vector<GridRing> out;
    for (std::size_t first = 0; first < chains_.size(); ++first)
      if (!used_[first]) walk_from(first, out);
    return out;
  }

 private:
  bool is_fork(std::size_t c) const {
    return (c > 0 && chains_[c - 1].from == chains_[c].from) ||
           (c + 1 < chains_.size() && chains_[c + 1].from == chains_[c].from);
  }

  /// The chain that bounds the same ground next, where chain c ends: the first one clockwise. `start` where
  /// the walk is over.
  std::size_t next_after(std::size_t c, std::size_t start) const {
    const GridPoint node = chains_[c].to;
    const auto first = std::lower_bound(chains_.begin(), chains_.end(), node,
                                        [](const Chain& chain, GridPoint p) { return chain.from < p; });
    const ClockwiseFrom before{less(chains_[c].last_but_one, node)};
    std::size_t best = chains_.size();
    for (auto chain = first; chain != chains_.end() && chain->from == node; ++chain) {
      const auto index = static_cast<std::size_t>(chain - chains_.begin());
      if (used_[index] && index != start) continue;
      if (best == chains_.size() || before(less(chain->second, node), less(chains_[best].second, node)))
        best = index;
    }
    return best == chains_.size() ? start : best;
  }

  /// A walk that comes to a fork again leaves a ring behind.
  void walk_from(std::size_t start, std::vector<GridRing>& out) {
    std::vector<std::size_t> way;
    std::unordered_map<GridPoint, std::size_t, PointHash> forks;
    for (std::size_t c = start;;) {
      if (is_fork(c)) {
        const auto [found, is_new] = forks.emplace(chains_[c].from, way.size());
        if (!is_new) leave(way, found->second, forks, out);
        forks[chains_[c].from] = way.size();
      }
      way.push_back(c);
      used_[c] = true;
      c = next_after(c, start);
      if (c == start) break;
    }
    leave(way, 0, forks, out);
  }

  /// Takes the ring from place `first` on off the way.
  void leave(std::vector<std::size_t>& way, std::size_t first,
             std::unordered_map<GridPoint, std::size_t, PointHash>& forks, std::vector<GridRing>& out) const {
    GridRing ring;
    for (std::size_t i = first; i < way.size(); ++i) {
      const Chain& chain = chains_[way[i]];
      ring.push_back(chain.from);
      for (std::size_t k = 1; chain.points != nullptr && k + 1 < chain.count; ++k)
        ring.push_back(placed(chain.points[k], chain.corner));
      if (i > first) forks.erase(chain.from);
    }
    way.resize(first);
    out.push_back(std::move(ring));
  }

  std::vector<Chain> chains_;
  std::vector<bool> used_;
};

/// Without points that lie exactly on the line between their neighbours.
GridRing cornered(const GridRing& ring) {
  GridRing out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint before = out.empty() ? ring.back() : out.back();
    if (turn(before, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]) != 0) out.push_back(ring[i]);
  }
  return out;
}

bool is_thin(const GridRing& ring, Int128 twice_area) {
  double perimeter = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint step = less(ring[i + 1 < ring.size() ? i + 1 : 0], ring[i]);
    perimeter += std::hypot(static_cast<double>(step.x), static_cast<double>(step.y));
  }
  return std::abs(static_cast<double>(twice_area)) < kThinnest * perimeter;
}

Ring in_metres(const GridRing& ring, double unit_m) {
  Ring out;
  out.reserve(ring.size());
  for (const GridPoint p : ring)
    out.push_back({static_cast<double>(p.x) * unit_m, static_cast<double>(p.y) * unit_m});
  return out;
}

}  // namespace

Region assembled(const std::vector<TileOutline>& outlines, std::vector<BorderEdge> border,
                 const TileFrame& frame) {
  const std::int64_t side = frame.side;
  std::vector<Chain> chains;
  for (const TileOutline& outline : outlines) {
    append_chains(outline, side, chains);
    border.insert(border.end(), outline.border.begin(), outline.border.end());
  }
  append_border(border, side, chains);
  std::vector<GridRing> outer, holes;
  for (const GridRing& walked : ChainWalk(std::move(chains)).rings()) {
    GridRing ring = cornered(walked);
    if (ring.size() < 3) continue;
    const Int128 size = twice_area(ring);
    if (is_thin(ring, size)) continue;
    (size > 0 ? outer : holes).push_back(std::move(ring));
  }
  Region out;
  out.reserve(outer.size());
  for (const GridRing& ring : outer) out.push_back({in_metres(ring, frame.unit_m), {}});
  const std::vector<std::size_t> parents = parents_of(holes, outer);
  for (std::size_t i = 0; i < holes.size(); ++i)
    if (parents[i] < out.size()) out[parents[i]].holes.push_back(in_metres(holes[i], frame.unit_m));
  return out;
}

}  // namespace tramline::coverage
