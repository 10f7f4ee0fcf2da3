#include "tramline/cost/worked/worked_bands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "tramline/cost/tolerances.h"
#include "tramline/cost/worked/worked_rows.h"
#include "tramline/geometry/offset/contour.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The plane along and across one segment of the reference.
class Block {
 public:
  explicit Block(const ContourElement& along) : along_(along) {}

  /// Positions along the reference that the segment of a track runs beside; nullopt where it is not parallel
  /// to this segment.
  std::optional<Interval> shadow_of(const PathSegment& segment, double right_m) const {
    if (segment.straight() != along_.straight) return std::nullopt;
    const std::optional<double> a = foot_of(segment.from, right_m), b = foot_of(segment.to, right_m);
    if (!a || !b || std::abs(*b - *a) <= kSamePlace_m) return std::nullopt;
    const double curvature = *a < *b ? segment.curvature : -segment.curvature;
    if (!along_.straight && std::abs(curvature * (along_.signed_radius + right_m) - 1) > kPathRadius_share)
      return std::nullopt;
    return Interval{std::min(*a, *b), std::max(*a, *b)};
  }

  void add(int track, const Interval& shadow) { worked_[track].push_back(shadow); }

  /// Appends the worked area as polygons in the field's frame.
  void append_worked(double width_m, double sagitta_m, Region& out) {
    for (const Polygon& part : faces_of(edges(width_m))) {
      Polygon in_field{on_field(part.outer, sagitta_m), {}};
      for (const Ring& hole : part.holes) in_field.holes.push_back(on_field(hole, sagitta_m));
      append_valid(std::move(in_field), out);
    }
  }

  /// Appends a polygon, made valid where rounding folds it as the inner edge of an arc shrinks to a point.
  static void append_valid(Polygon polygon, Region& out) {
    if (!find_invalidity(polygon)) {
      out.push_back(std::move(polygon));
      return;
    }
    for (Polygon& part : made_valid(polygon)) out.push_back(std::move(part));
  }

 private:
  /// The position along the segment of a point at this distance to its right, from 0 to its length; nullopt
  /// where it is not beside it.
  std::optional<double> foot_of(Point p, double right_m) const {
    double position = 0, off_m = 0;
    if (along_.straight) {
      position = dot(along_.heading, p - along_.from);
      off_m = cross(p - along_.from, along_.heading) - right_m;
    } else {
      const Point from_centre = (1 / (along_.signed_radius + right_m)) * (p - along_.centre);
      const Point first{along_.heading.y, -along_.heading.x};
      position = along_.signed_radius * std::atan2(cross(first, from_centre), dot(first, from_centre));
      off_m = (length(from_centre) - 1) * (along_.signed_radius + right_m);
    }
    if (!(std::abs(off_m) <= kSamePlace_m)) return std::nullopt;
    if (position < -kSamePlace_m || position > along_.length + kSamePlace_m) return std::nullopt;
    if (position < kSamePlace_m) return 0;
    return position > along_.length - kSamePlace_m ? along_.length : position;
  }

  /// Edges of the worked area: x across to the right, y along, oriented as in the field.
  std::vector<DirectedEdge> edges(double width_m) {
    for (auto& [track, shadows] : worked_) shadows = joined(std::move(shadows));
    static const Intervals nothing;
    std::vector<DirectedEdge> out;
    for (const auto& [track, shadows] : worked_) {
      const auto before = worked_.find(track - 1);
      const double left = track * width_m, right = (track + 1) * width_m;
      append_edges_along(left, before == worked_.end() ? nothing : before->second, shadows, out);
      if (!worked_.contains(track + 1)) append_edges_along(right, shadows, nothing, out);
      for (const Interval& part : shadows) {
        out.push_back({{left, part.from}, {right, part.from}});
        out.push_back({{right, part.to}, {left, part.to}});
      }
    }
    return out;
  }

  static Intervals joined(Intervals shadows) {
    std::sort(shadows.begin(), shadows.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    Intervals out;
    for (const Interval& next : shadows) append_joining(out, next);
    return out;
  }

  Ring on_field(const Ring& ring, double sagitta_m) const {
    Ring out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const double signed_radius = along_.signed_radius + a.x;
      const Point from = to_field(a), to = to_field(b);
      if (a.x != b.x || along_.straight || distance(from, to) < kSamePlace_m) {
        out.push_back(from);
        continue;
      }
      const double curvature = b.y > a.y ? 1 / signed_radius : -1 / signed_radius;
      std::vector<Point> arc = chords({{from, to, curvature}}, sagitta_m);
      out.insert(out.end(), arc.begin(), arc.end() - 1);
    }
    return out;
  }

  Point to_field(Point across_and_along) const {
    return beside(along_, along_.start + across_and_along.y, across_and_along.x);
  }

  const ContourElement& along_;
  std::map<int, Intervals> worked_;  ///< by track
};

/// The block that a segment runs along. Tracks follow the reference: mostly the last one or its neighbours.
class BlockFinder {
 public:
  explicit BlockFinder(std::vector<Block>& blocks) : blocks_(blocks) {}

  bool add(const PathSegment& segment, int track, double right_m) {
    const std::size_t n = blocks_.size();
    for (const std::size_t i : {last_, last_ + 1, last_ + n - 1})
      if (add_to(i % n, segment, track, right_m)) return true;
    for (std::size_t i = 0; i < n; ++i)
      if (add_to(i, segment, track, right_m)) return true;
    return false;
  }

 private:
  bool add_to(std::size_t block, const PathSegment& segment, int track, double right_m) {
    const std::optional<Interval> shadow = blocks_[block].shadow_of(segment, right_m);
    if (!shadow) return false;
    blocks_[block].add(track, *shadow);
    last_ = block;
    return true;
  }

  std::vector<Block>& blocks_;
  std::size_t last_ = 0;
};

}  // namespace

std::vector<Region> worked_bands(const Path& reference, const std::vector<TrackPiece>& pieces, double width_m,
                                 double sagitta_m) {
  const Contour contour = contour_of(reference);
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < contour.segments; ++i) blocks.emplace_back(contour.elements[i]);
  BlockFinder finder(blocks);
  std::vector<Region> out(3);
  for (const TrackPiece& piece : pieces) {
    Region& corners = out[piece.track % 2 == 0 ? 1 : 2];
    Path corner;
    const auto finish_corner = [&] {
      if (!corner.empty()) Block::append_valid({band(corner, width_m, sagitta_m), {}}, corners);
      corner.clear();
    };
    for (const PathSegment& segment : piece.curve)
      if (finder.add(segment, piece.track, (piece.track + 0.5) * width_m))
        finish_corner();
      else
        corner.push_back(segment);
    finish_corner();
  }
  Region ground;
  for (Block& block : blocks) block.append_worked(width_m, sagitta_m, ground);
  out[0] = unite(ground);
  return out;
}

}  // namespace tramline
