#include "tramline/coverage/tiles/nest_holes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/index/span_index.h"
#include "tramline/geometry/interval.h"

namespace tramline::coverage {
namespace {

/// An edge that is not level, upwards.
struct RingEdge {
  GridPoint low;
  GridPoint high;
  std::size_t ring = 0;

  /// Just above that height, too.
  bool reaches(std::int64_t y) const { return low.y <= y && y < high.y; }
  double place_at(std::int64_t y) const {
    const double t = static_cast<double>(y - low.y) / static_cast<double>(high.y - low.y);
    return static_cast<double>(low.x) + t * static_cast<double>(high.x - low.x);
  }
  /// Positive where `other` turns further to the west on its way up.
  Int128 leans_less_west_than(const RingEdge& other) const {
    return static_cast<Int128>(high.x - low.x) * (other.high.y - other.low.y) -
           static_cast<Int128>(high.y - low.y) * (other.high.x - other.low.x);
  }
};

void append_edges(const GridRing& ring, std::size_t number, std::vector<RingEdge>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint from = ring[i], to = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (from.y != to.y)
      out.push_back(from.y < to.y ? RingEdge{from, to, number} : RingEdge{to, from, number});
  }
}

/// Its edges, and where those of every height are.
struct EdgeRows {
  explicit EdgeRows(std::vector<RingEdge> given) : edges(std::move(given)), rows(spans(edges)) {}

  static std::vector<Interval> spans(const std::vector<RingEdge>& edges) {
    std::vector<Interval> out;
    out.reserve(edges.size());
    for (const RingEdge& e : edges)
      out.push_back({static_cast<double>(e.low.y), static_cast<double>(e.high.y)});
    return out;
  }

  std::vector<RingEdge> edges;
  SpanIndex rows;
};

/// Of two edges that meet at a height, in units: this far apart they may still meet.
constexpr double kMeet = 1e-3;

/// Whether edge a lies east of b at that height, or where they meet there, just above it.
bool east_of(const RingEdge& a, const RingEdge& b, std::int64_t y) {
  const double apart = a.place_at(y) - b.place_at(y);
  return std::abs(apart) > kMeet ? apart > 0 : a.leans_less_west_than(b) > 0;
}

/// The first edge of another ring west of a corner of a ring, just above it; nullptr: none. Edges that pass
/// through the corner count where they go on west of the ring's own.
const RingEdge* first_west_of(GridPoint corner, std::size_t ring, const EdgeRows& all) {
  const auto near = all.rows.near(static_cast<double>(corner.y));
  const RingEdge* own = nullptr;
  for (const std::uint32_t i : near) {
    const RingEdge& e = all.edges[i];
    if (e.ring != ring || e.low != corner) continue;
    if (own == nullptr || own->leans_less_west_than(e) > 0) own = &e;
  }
  const RingEdge* first = nullptr;
  for (const std::uint32_t i : near) {
    const RingEdge& e = all.edges[i];
    if (e.ring == ring || !e.reaches(corner.y)) continue;
    const Int128 side = turn(e.low, e.high, corner);
    const bool west = side < 0 || (side == 0 && (own == nullptr || own->leans_less_west_than(e) > 0));
    if (west && (first == nullptr || east_of(e, *first, corner.y))) first = &e;
  }
  return first;
}

}  // namespace

Int128 twice_area(const GridRing& ring) {
  Int128 out = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) out += turn(ring[0], ring[i - 1], ring[i]);
  return out;
}

// West of the westernmost corner of a hole (of those, the southernmost) lies the ground that it is a hole of.
// The first edge that one meets there belongs to the same ground: its outer ring, or another hole. That
// hole's own such corner lies further west, so that the way ends.
std::vector<std::size_t> parents_of(const std::vector<GridRing>& holes, const std::vector<GridRing>& outer) {
  assert(std::all_of(outer.begin(), outer.end(), [](const GridRing& ring) { return twice_area(ring) > 0; }));
  assert(std::all_of(holes.begin(), holes.end(), [](const GridRing& ring) { return twice_area(ring) < 0; }));
  std::vector<std::size_t> parents(holes.size(), outer.size());
  if (holes.empty()) return parents;
  std::vector<RingEdge> edges;
  for (std::size_t i = 0; i < outer.size(); ++i) append_edges(outer[i], i, edges);
  for (std::size_t i = 0; i < holes.size(); ++i) append_edges(holes[i], outer.size() + i, edges);
  const EdgeRows all(std::move(edges));

  std::vector<std::pair<GridPoint, std::size_t>> from_west;
  for (std::size_t i = 0; i < holes.size(); ++i)
    from_west.emplace_back(*std::min_element(holes[i].begin(), holes[i].end()), i);
  std::sort(from_west.begin(), from_west.end());
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> west(holes.size(), kNone);
  for (const auto& [corner, hole] : from_west)
    if (const RingEdge* first = first_west_of(corner, outer.size() + hole, all)) west[hole] = first->ring;
  for (const auto& [corner, hole] : from_west) {
    std::size_t ring = west[hole];
    for (std::size_t n = 0; n < holes.size() && ring != kNone && ring >= outer.size(); ++n)
      ring = west[ring - outer.size()];
    west[hole] = ring;  // a hole further east that leads here has it at once
    if (ring < outer.size()) parents[hole] = ring;
  }
  return parents;
}

}  // namespace tramline::coverage
