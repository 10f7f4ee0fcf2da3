#include "tramline/planner/gap_grids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tramline/geometry/bounding_rectangle.h"
#include "tramline/geometry/interior_point.h"
#include "tramline/geometry/significant_vertices.h"
#include "tramline/geometry/simplified_line.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

struct Edge {
  Point a, b;
};

/// The longest edges, as many as asked for, the longest first.
void append_longest(std::vector<Edge> edges, std::size_t most, std::vector<Direction>& out) {
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& x, const Edge& y) { return distance(x.a, x.b) > distance(y.a, y.b); });
  if (edges.size() > most) edges.resize(most);
  for (const Edge& edge : edges) out.push_back(Direction::along(edge.a, edge.b));
}

void append_edges(const Ring& ring, std::vector<Edge>& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Edge edge{ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]};
    if (distance(edge.a, edge.b) > 1e-3) out.push_back(edge);
  }
}

/// Edges of the gaps themselves, the wobble of a drive smoothed away.
std::vector<Edge> own_edges(const Region& gaps) {
  constexpr double kWobble_m = 0.3;
  std::vector<Edge> out;
  for (const Polygon& gap : gaps) {
    Ring ring;
    for (const std::size_t i : significant_vertices(gap.outer, kWobble_m)) ring.push_back(gap.outer[i]);
    append_edges(ring, out);
  }
  return out;
}

/// Edges of the ground that may be driven, with gaps beside them: those of the field and of obstacles.
std::vector<Edge> edges_beside(const GapGround& ground, double width_m) {
  std::vector<Edge> edges, out;
  for (const Ring& ring : rings_of(ground.free)) append_edges(ring, edges);
  const Box near = bounds(ground.gaps).grown(0.5 * width_m);
  for (const Edge& edge : edges) {
    Box box;
    box.extend(edge.a);
    box.extend(edge.b);
    if (!intersects(box, near)) continue;
    const bool beside = std::any_of(ground.gaps.begin(), ground.gaps.end(), [&](const Polygon& gap) {
      return std::any_of(gap.outer.begin(), gap.outer.end(),
                         [&](Point p) { return distance_to_segment(p, edge.a, edge.b) < 0.5 * width_m; });
    });
    if (beside) out.push_back(edge);
  }
  return out;
}

std::vector<Direction> without_near_ones(const std::vector<Direction>& all) {
  constexpr double kNear_deg = 0.1;
  std::vector<Direction> out;
  for (const Direction direction : all)
    if (std::none_of(out.begin(), out.end(),
                     [&](Direction other) { return angle_between(direction, other).degrees() < kNear_deg; }))
      out.push_back(direction);
  return out;
}

void append_directions_of(const Ring& hull, std::vector<Direction>& out) {
  if (hull.size() < 3 || signed_area(hull) <= 0) return;
  out.push_back(long_side_of_smallest_rectangle(hull));
  out.push_back(across_least_width(hull));
}

/// Where line 0 may lie, modulo the width.
std::vector<double> origins(const GapGround& ground, const TrackFrame& frame, double width_m) {
  constexpr int kPhases = 8;
  const Box box = bounds(frame.to_track(ground.gaps));
  const double rows = std::ceil(box.width() / width_m - 1e-9);
  std::vector<double> out{0.5 * (box.min_x + box.max_x - rows * width_m), box.min_x, box.max_x};
  // Flush with what is parallel and must not be crossed.
  for (const Ring& ring : rings_of(frame.to_track(ground.free)))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const bool parallel = std::abs(b.x - a.x) <= kParallelRadians * std::abs(b.y - a.y);
      const double x = 0.5 * (a.x + b.x);
      if (parallel && std::abs(b.y - a.y) > 0.25 * width_m && x > box.min_x - width_m &&
          x < box.max_x + width_m)
        out.push_back(x);
    }
  for (int i = 1; i < kPhases; ++i) out.push_back(box.min_x + i * width_m / kPhases);
  return out;
}

/// What is left for another direction, and what no line meets.
double price_of_rest(const GapGround& ground, const GapLines& all, const GapLines& kept,
                     const RepairTerms& terms) {
  const double width_m = terms.machine.width_m;
  double price = 0;
  for (const GapLine& line : all.lines) {
    const bool is_kept = std::any_of(kept.lines.begin(), kept.lines.end(), [&](const GapLine& other) {
      return other.pieces.front().strip == line.pieces.front().strip &&
             other.pieces.front().from == line.pieces.front().from;
    });
    if (!is_kept)
      price += terms.objective.overlap * std::max(0.0, width_m * width_m - line.covered_m2) +
               0.25 * terms.objective.turn;
  }
  const double missed_m2 = std::max(0.0, ground.gaps_m2 - all.covered_m2);
  return price + 10 * std::max(terms.objective.uncovered, terms.objective.overlap) * missed_m2;
}

/// Without the lines that only cross an arm of the ground which lies along another direction.
GapLines worth_driving(const GapLines& all, const RepairTerms& terms) {
  double longest_m = 0, most_m2 = 0;
  for (const GapLine& line : all.lines) {
    longest_m = std::max(longest_m, line.length_m);
    most_m2 = std::max(most_m2, line.covered_m2);
  }
  const double least_m = std::min(2 * terms.machine.width_m, 0.5 * longest_m);
  GapLines out{all.grid, {}, 0, 0};
  for (const GapLine& line : all.lines) {
    if (line.length_m < least_m && line.covered_m2 < most_m2) continue;
    out.covered_m2 += line.covered_m2;
    out.price += price_of(line, terms);
    out.lines.push_back(line);
  }
  return out;
}

}  // namespace

std::vector<Direction> gap_directions(const GapGround& ground, double width_m, GapEffort effort) {
  std::vector<Direction> out;
  std::vector<Point> points;
  for (const Polygon& gap : ground.gaps) points.insert(points.end(), gap.outer.begin(), gap.outer.end());
  append_directions_of(hull_of(std::move(points)), out);
  if (ground.gaps.size() == 2) {
    const Point a = interior_point(ground.gaps[0]), b = interior_point(ground.gaps[1]);
    if (distance(a, b) > 1e-3) out.push_back(Direction::along(a, b));
  }
  if (effort != GapEffort::kGlance) {
    append_longest(own_edges(ground.gaps), 6, out);
    append_longest(edges_beside(ground, width_m), effort == GapEffort::kThorough ? 24 : 6, out);
  }
  if (effort == GapEffort::kThorough)
    for (int i = 0; i < 24; ++i) out.push_back(Direction::clockwise_from_north(Angle::degrees(7.5 * i)));
  if (effort != GapEffort::kThorough) out = along_narrow_gaps(ground, width_m, out);
  return without_near_ones(out);
}

std::vector<Direction> along_narrow_gaps(const GapGround& ground, double width_m,
                                         const std::vector<Direction>& directions) {
  constexpr double kSlim = 3, kOff_deg = 10;
  std::vector<Direction> axes;
  for (const Polygon& gap : ground.gaps) {
    const Direction axis = long_side_of_smallest_rectangle(gap.outer);
    const Box box = bounds(TrackFrame(axis).to_track(gap.outer));
    if (box.width() < width_m && box.height() >= kSlim * box.width()) axes.push_back(axis);
  }
  std::vector<Direction> out;
  for (const Direction direction : directions)
    if (std::all_of(axes.begin(), axes.end(),
                    [&](Direction axis) { return angle_between(direction, axis).degrees() <= kOff_deg; }))
      out.push_back(direction);
  return out;
}

std::optional<GapChoice> best_lines(const GapGround& ground, const std::vector<Direction>& directions,
                                    const RepairTerms& terms, double least_m2, double least_width_m,
                                    ShortLines short_lines) {
  std::optional<GapChoice> best;
  for (const Direction direction : directions) {
    const TrackFrame frame(direction);
    for (const double origin_m : origins(ground, frame, terms.machine.width_m)) {
      const GapLines all = lines_on(ground, {frame, origin_m, terms.machine.width_m}, terms, least_width_m);
      GapLines kept = short_lines == ShortLines::kDrive ? all : worth_driving(all, terms);
      if (kept.lines.empty() || kept.covered_m2 < least_m2) continue;
      const double price = kept.price + price_of_rest(ground, all, kept, terms);
      // Rounding decides nothing: the first of equals stays.
      if (!best || price < best->price - 1e-9 * std::abs(best->price)) best = {std::move(kept), price};
    }
  }
  return best;
}

}  // namespace tramline
