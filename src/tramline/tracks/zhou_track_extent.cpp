#include "tramline/tracks/zhou_track_extent.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/end_rule.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

/// Π of Zhou §2.2.
Region buffer(const Path& path, double width_m) {
  const Polygon outline{kinked_band(path, width_m), {}};
  if (!find_invalidity(outline)) return {outline};
  Region cells;
  for (Ring& cell : kinked_cells(path, width_m)) cells.push_back({std::move(cell), {}});
  return unite(cells);
}

/// ⊥ of Zhou §2.2: positions along the path of the points nearest to p.
class Projection {
 public:
  explicit Projection(const Path& path) {
    double at = 0;
    for (const PathSegment& segment : path) {
      const double length_m = length(segment);
      sides_.push_back({segment.from, (1 / length_m) * (segment.to - segment.from), length_m, at});
      at += length_m;
    }
  }

  double foot(Point p) const {
    double least = std::numeric_limits<double>::infinity(), out = 0;
    for (const Side& side : sides_) {
      const Point to = p - side.from;
      const double along = std::clamp(dot(to, side.along), 0.0, side.length_m);
      const Point off = to - along * side.along;
      const double square = dot(off, off);
      if (square >= least) continue;
      least = square;
      out = side.at_m + along;
    }
    return out;
  }

 private:
  struct Side {
    Point from;
    Point along;
    double length_m;
    double at_m;
  };
  std::vector<Side> sides_;
};

}  // namespace

Intervals zhou_track_extent(const Path& path, double width_m, const Polygon& body) {
  assert(std::all_of(path.begin(), path.end(), [](const PathSegment& s) { return s.straight(); }));
  if (!intersects(reach_of(path, width_m), bounds(body))) return {};
  const Projection projection(path);
  std::vector<Interval> pieces;
  for (const Polygon& piece : intersection(buffer(path, width_m - 2 * kWidthTolerance), {body})) {
    Interval reach{std::numeric_limits<double>::infinity(), 0};
    for (const Point vertex : piece.outer) {
      const double foot = projection.foot(vertex);
      reach.from = std::min(reach.from, foot);
      reach.to = std::max(reach.to, foot);
    }
    if (reach.length() >= kNoPiece_m) pieces.push_back(reach);
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  Intervals out;
  for (const Interval& piece : pieces) append_joining(out, piece);
  return out;
}

}  // namespace tramline
