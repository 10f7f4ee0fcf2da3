#include "tramline/coverage/tiles/tile_outline.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tramline/coverage/tiles/snapped_edges.h"

namespace tramline::coverage {
namespace {

/// Edges that only one cell of the ground has.
std::vector<TileEdge> outer_edges(const CellStore& cells, StateSet states) {
  std::size_t count = 0;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (holds(states, cells.state(c))) count += cells.ring(c).size();
  std::vector<TileEdge> out;
  if (count == 0) return out;
  EdgeSum sum(count);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!holds(states, cells.state(c))) continue;
    const std::span<const TilePoint> ring = cells.ring(c);
    for (std::size_t i = 0; i < ring.size(); ++i) sum.add(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  }
  sum.each_remaining([&](TilePoint from, TilePoint to) { out.push_back({from, to}); });
  return out;
}

bool on_border(TilePoint p, std::int32_t side) { return p.x == 0 || p.y == 0 || p.x == side || p.y == side; }

bool along_border(const TileEdge& e, std::int32_t side) {
  return (e.from.x == e.to.x && (e.from.x == 0 || e.from.x == side)) ||
         (e.from.y == e.to.y && (e.from.y == 0 || e.from.y == side));
}

/// The border of the plane's tiles, as one of them sees it.
class Border {
 public:
  Border(TileIndex tile, std::int32_t side) : tile_(tile), side_(side) {}

  void add_edge(const TileEdge& e) {
    const bool upright = e.from.x == e.to.x && (e.from.x == 0 || e.from.x == side_);
    lines_[number(upright, upright ? e.from.x : e.from.y)].push_back(upright ? Stretch{e.from.y, e.to.y}
                                                                             : Stretch{e.from.x, e.to.x});
  }
  /// Something ends here that does not run along the border.
  void add_end(TilePoint p) {
    if (p.x == 0 || p.x == side_) ends_[number(true, p.x)].push_back(p.y);
    if (p.y == 0 || p.y == side_) ends_[number(false, p.y)].push_back(p.x);
  }

  /// Stretches that continue one another where nothing ends become one.
  std::vector<BorderEdge> edges() {
    std::vector<BorderEdge> out;
    for (std::size_t n = 0; n < lines_.size(); ++n) {
      std::sort(ends_[n].begin(), ends_[n].end());
      std::sort(lines_[n].begin(), lines_[n].end(), [](const Stretch& a, const Stretch& b) {
        return std::pair(a.low(), a.high()) < std::pair(b.low(), b.high());
      });
      std::vector<Stretch> joined;
      for (const Stretch& s : lines_[n]) {
        const bool goes_on = !joined.empty() && joined.back().high() == s.low() &&
                             joined.back().up() == s.up() &&
                             !std::binary_search(ends_[n].begin(), ends_[n].end(), s.low());
        if (!goes_on)
          joined.push_back(s);
        else if (s.up())
          joined.back().to = s.to;
        else
          joined.back().from = s.from;
      }
      for (const Stretch& s : joined) out.push_back(placed(n, s.from, s.to));
      ends_[n].erase(std::unique(ends_[n].begin(), ends_[n].end()), ends_[n].end());
      for (const std::int32_t at : ends_[n]) out.push_back(placed(n, at, at));
    }
    return out;
  }

 private:
  struct Stretch {
    std::int32_t from = 0;
    std::int32_t to = 0;

    bool up() const { return to > from; }
    std::int32_t low() const { return std::min(from, to); }
    std::int32_t high() const { return std::max(from, to); }
  };

  static std::size_t number(bool upright, std::int32_t at) {
    return (upright ? 0U : 2U) + (at == 0 ? 0U : 1U);
  }
  BorderEdge placed(std::size_t n, std::int32_t from, std::int32_t to) const {
    const bool upright = n < 2;
    const std::int32_t across = upright ? tile_.column : tile_.row;
    const std::int64_t begin = (upright ? tile_.row : tile_.column) * std::int64_t{side_};
    return {upright, across + static_cast<std::int32_t>(n % 2), begin + from, begin + to};
  }

  TileIndex tile_;
  std::int32_t side_;
  std::array<std::vector<Stretch>, 4> lines_;  ///< west, east, south, north
  std::array<std::vector<std::int32_t>, 4> ends_;
};

/// Links edges to chains that run from fork to fork, or from border to border.
class Chains {
 public:
  Chains(std::vector<TileEdge> edges, std::int32_t side) : edges_(std::move(edges)), side_(side) {
    std::sort(edges_.begin(), edges_.end(), [](const TileEdge& a, const TileEdge& b) {
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    used_.assign(edges_.size(), false);
  }

  void append_to(TileOutline& out) {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (breaks_at(e)) append_from(e, out);
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!used_[e]) append_from(e, out);
  }

 private:
  /// Whether a chain has to begin with this edge.
  bool breaks_at(std::size_t e) const {
    const TilePoint from = edges_[e].from;
    return on_border(from, side_) || (e > 0 && edges_[e - 1].from == from) ||
           (e + 1 < edges_.size() && edges_[e + 1].from == from);
  }

  void append_from(std::size_t e, TileOutline& out) {
    if (used_[e]) return;
    out.points.push_back(edges_[e].from);
    for (;;) {
      used_[e] = true;
      const TilePoint to = edges_[e].to;
      out.points.push_back(to);
      if (on_border(to, side_)) break;
      const auto next = std::lower_bound(edges_.begin(), edges_.end(), to,
                                         [](const TileEdge& edge, TilePoint p) { return edge.from < p; });
      e = static_cast<std::size_t>(next - edges_.begin());
      if (next == edges_.end() || used_[e] || breaks_at(e)) break;
    }
    out.ends.push_back(static_cast<std::uint32_t>(out.points.size()));
  }

  std::vector<TileEdge> edges_;
  std::vector<bool> used_;
  std::int32_t side_;
};

}  // namespace

TileOutline outline_of(TileIndex tile, const CellStore& cells, StateSet states, std::int64_t side) {
  TileOutline out;
  out.tile = tile;
  std::vector<TileEdge> outer = outer_edges(cells, states);
  if (outer.empty()) return out;
  const auto width = static_cast<std::int32_t>(side);
  Border border(tile, width);
  std::vector<TileEdge> inner;
  snapped(std::move(outer), width).each_remaining([&](TilePoint from, TilePoint to) {
    const TileEdge edge{from, to};
    if (along_border(edge, width)) return border.add_edge(edge);
    inner.push_back(edge);
    border.add_end(from);
    border.add_end(to);
  });
  out.border = border.edges();
  Chains(std::move(inner), width).append_to(out);
  return out;
}

}  // namespace tramline::coverage
