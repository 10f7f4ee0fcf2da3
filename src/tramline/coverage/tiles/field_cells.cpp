#include "tramline/coverage/tiles/field_cells.h"

#include <algorithm>
#include <cmath>

#include "tramline/coverage/tiles/tiles_reached.h"

namespace tramline::coverage {
namespace {

Interval rows_between(GridPoint a, GridPoint b) {
  return {static_cast<double>(std::min(a.y, b.y)), static_cast<double>(std::max(a.y, b.y))};
}

template <class Segments>
std::vector<Interval> row_spans(const Segments& segments) {
  std::vector<Interval> out;
  for (const auto& s : segments) out.push_back(rows_between(s.from, s.to));
  return out;
}

/// Tiles that the boundary comes this close to are its tiles too, units.
constexpr std::int64_t kBesideSegment = 64;

/// Shorter edges may point anywhere.
constexpr double kTelling = 1024;

/// Whether more than a touch of the segment lies within the ring.
bool passes(const TileLine& segment, const TileRing& ring) {
  const double dx = segment.to_x - segment.from_x, dy = segment.to_y - segment.from_y;
  const double length = std::sqrt(dx * dx + dy * dy);
  double from = 0, to = length;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const TilePoint a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double ex = static_cast<double>(b.x) - a.x, ey = static_cast<double>(b.y) - a.y;
    const double edge = std::sqrt(ex * ex + ey * ey);
    if (edge < kTelling) continue;
    // How far left of the edge the segment's ends lie.
    const double at_from = (ex * (segment.from_y - a.y) - ey * (segment.from_x - a.x)) / edge;
    const double at_to = (ex * (segment.to_y - a.y) - ey * (segment.to_x - a.x)) / edge;
    if (at_from <= 0 && at_to <= 0) return false;
    if (at_from < 0) from = std::max(from, length * at_from / (at_from - at_to));
    if (at_to < 0) to = std::min(to, length * at_from / (at_from - at_to));
  }
  return to - from > kOnLine;
}

}  // namespace

FieldCells::FieldCells(const Region& field, const TileFrame& frame)
    : frame_(frame), rows_(std::vector<Interval>{}) {
  for (const Polygon& polygon : field)
    for (const Ring& ring : rings_of({polygon})) {
      const GridPoint first = frame.rounded(ring.front());
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const GridPoint from = frame.rounded(ring[i]), to = frame.rounded(ring[(i + 1) % ring.size()]);
        if (from == to) continue;
        segments_.push_back({from, to});
        twice_area_ += turn(first, from, to);
      }
    }
  rows_ = SpanIndex(row_spans(segments_));
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    each_tile_reached(
        frame, 2, [&](std::size_t k) { return k == 0 ? s.from : s.to; }, kBesideSegment,
        [&](TileIndex tile) { passing_.emplace_back(tile, static_cast<std::uint32_t>(i)); });
  }
  std::sort(passing_.begin(), passing_.end());
}

bool FieldCells::contains(double x, double y) const {
  if (segments_.empty()) return false;
  bool inside = false;
  for (const std::uint32_t i : rows_.near(y)) {
    const GridPoint a = segments_[i].from, b = segments_[i].to;
    const auto ay = static_cast<double>(a.y), by = static_cast<double>(b.y);
    if ((ay > y) == (by > y)) continue;
    const double at = static_cast<double>(a.x) + (y - ay) / (by - ay) * static_cast<double>(b.x - a.x);
    if (at > x) inside = !inside;
  }
  return inside;
}

std::vector<TileIndex> FieldCells::border_tiles() const {
  std::vector<TileIndex> out;
  for (const auto& [tile, segment] : passing_)
    if (out.empty() || !(out.back() == tile)) out.push_back(tile);
  return out;
}

void FieldCells::cut_along(const Segment& segment, GridPoint corner, CellStore& cells,
                           CutScratch& scratch) const {
  const TileLine line = tile_line(line_through(segment.from, segment.to), segment.from, segment.to, corner);
  if (scratch.outside.empty()) scratch.outside.emplace_back();
  const std::size_t count = cells.size();
  for (std::size_t c = 0; c < count; ++c) {
    scratch.ring.assign(cells.ring(c).begin(), cells.ring(c).end());
    scratch.distance.clear();
    for (const TilePoint p : scratch.ring) scratch.distance.push_back(line.inside(p));
    const auto [least, most] = std::minmax_element(scratch.distance.begin(), scratch.distance.end());
    if (*least >= -kOnLine || *most <= kOnLine || !passes(line, scratch.ring)) continue;
    split(scratch.ring, scratch.distance, line, frame_.side, scratch.inside, scratch.outside[0]);
    if (scratch.inside.empty() || scratch.outside[0].empty()) continue;
    cells.replace(c, scratch.inside, 0);
    cells.add(scratch.outside[0], 0);
  }
}

void FieldCells::partition(TileIndex tile, CellStore& out, CutScratch& scratch) const {
  const auto side = static_cast<std::int32_t>(frame_.side);
  const GridPoint corner = frame_.corner(tile);
  out.add({{0, 0}, {side, 0}, {side, side}, {0, side}}, 0);
  const auto first = std::lower_bound(passing_.begin(), passing_.end(), std::pair{tile, std::uint32_t{0}});
  for (auto at = first; at != passing_.end() && at->first == tile; ++at)
    cut_along(segments_[at->second], corner, out, scratch);
  for (std::size_t c = 0; c < out.size(); ++c) {
    double x = 0, y = 0;
    for (const TilePoint p : out.ring(c)) {
      x += p.x;
      y += p.y;
    }
    const auto count = static_cast<double>(out.ring(c).size());
    const bool in =
        contains(static_cast<double>(corner.x) + x / count, static_cast<double>(corner.y) + y / count);
    out.set_state(c, in ? kUnworkedField : kUnworkedOutside);
  }
}

}  // namespace tramline::coverage
