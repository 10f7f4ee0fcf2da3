#include "tramline/cost/bound/strip_passages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/cost/tolerances.h"

namespace tramline {
namespace {

/// Whether both are boxes of the same ring, but for the precision grid.
bool is_same(const Box& a, const Box& b) {
  return std::max({std::abs(a.min_x - b.min_x), std::abs(a.max_x - b.max_x), std::abs(a.min_y - b.min_y),
                   std::abs(a.max_y - b.max_y)}) < kWidthTolerance;
}

bool contains_point(const Box& box, Point p) {
  return box.min_x <= p.x && p.x <= box.max_x && box.min_y <= p.y && p.y <= box.max_y;
}

/// Extent along of the part of a ring between two coordinates across. Empty (from > to) where there is none.
Interval extent_along(const Ring& ring, double left, double right) {
  Interval out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  Point a = ring.back();
  for (const Point b : ring) {
    const Point from = a;
    a = b;
    if (std::max(from.x, b.x) < left || std::min(from.x, b.x) > right) continue;
    for (const Point end : {from, b}) {
      const double x = std::clamp(end.x, left, right);
      const double y = from.x == b.x ? end.y : from.y + (b.y - from.y) * ((x - from.x) / (b.x - from.x));
      out = {std::min(out.from, y), std::max(out.to, y)};
    }
  }
  return out;
}

/// The points of a ring that lie farthest to either side among those in some rows.
struct Farthest {
  Point left{std::numeric_limits<double>::infinity(), 0};
  Point right{-std::numeric_limits<double>::infinity(), 0};
};

Farthest farthest_across(const Ring& ring, const Interval& rows) {
  Farthest out;
  Point a = ring.back();
  for (const Point b : ring) {
    const Point from = a;
    a = b;
    if (std::max(from.y, b.y) < rows.from || std::min(from.y, b.y) > rows.to) continue;
    for (const Point end : {from, b}) {
      const double y = std::clamp(end.y, rows.from, rows.to);
      const double x = from.y == b.y ? end.x : from.x + (b.x - from.x) * ((y - from.y) / (b.y - from.y));
      if (x < out.left.x) out.left = {x, y};
      if (x > out.right.x) out.right = {x, y};
    }
  }
  return out;
}

struct BlockedRows {
  double rows_m = 0;    ///< between two pieces
  double longer_m = 0;  ///< by which a detour is longer than its rows, at least
};

}  // namespace

StripPassages::StripPassages(const TurnedSubfield& subfield, const std::vector<DetourZone>& zones,
                             const PassageTerms& terms)
    : subfield_(subfield), zones_(zones), terms_(terms) {
  for (std::size_t i = 1; i < subfield.outline.size(); ++i) {
    const Box hole = bounds(subfield.outline[i]);
    const auto same = [&hole](const Box& obstacle) { return is_same(hole, obstacle); };
    if (std::any_of(subfield.obstacles.begin(), subfield.obstacles.end(), same))
      holes_.push_back({&subfield.outline[i], hole});
  }
}

StripPassages::HoleRows StripPassages::rows_of(const Hole& hole, double left, double right) const {
  HoleRows out;
  out.hole = &hole;
  const double low = left - terms_.shift_m, high = right + terms_.shift_m;
  out.rows = extent_along(*hole.ring, low, high);
  Point a = hole.ring->back();
  for (const Point b : *hole.ring) {
    out.edges += std::max(a.x, b.x) < low || std::min(a.x, b.x) > high ? 0 : 1;
    a = b;
  }
  out.rows.from -= terms_.shear_m + kWidthTolerance;
  out.rows.to += terms_.shear_m + kWidthTolerance;
  const double inner = terms_.shift_m + 2 * kNoPiece_m;
  out.blocks = hole.box.min_x < right - inner && hole.box.max_x > left + inner;
  return out;
}

Intervals StripPassages::enter(const StripGrid& grid, int strip) {
  left_ = grid.line(strip);
  right_ = grid.line(strip + 1);
  centre_ = grid.centre(strip);
  const double left = left_, right = left + terms_.width_m, touch = terms_.shift_m + kWidthTolerance;
  rows_.clear();
  Intervals all;
  for (const Hole& hole : holes_) {
    if (hole.box.min_x > right + touch || hole.box.max_x < left - touch) continue;
    const HoleRows rows = rows_of(hole, left, right);
    if (rows.edges == 0) continue;
    rows_.push_back(rows);
    all.push_back(rows.rows);
  }
  const auto is_hole = [this](const Box& box) {
    return std::any_of(holes_.begin(), holes_.end(),
                       [&box](const Hole& hole) { return is_same(hole.box, box); });
  };
  for (const Box& box : subfield_.obstacles)
    if (box.min_x <= right + touch && box.max_x >= left - touch && !is_hole(box))
      all.push_back(
          {box.min_y - terms_.shear_m - kWidthTolerance, box.max_y + terms_.shear_m + kWidthTolerance});
  std::sort(all.begin(), all.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  Intervals out;
  for (const Interval& one : all) append_joining(out, one);
  return out;
}

double StripPassages::cost(const Intervals& driven, const Intervals& pooled,
                           const std::vector<BoundaryWindow>& windows) const {
  const double cut = terms_.objective.turn + 2 * terms_.objective.stop;
  std::vector<BlockedRows> blocked;
  for (std::size_t i = 0; i + 1 < driven.size(); ++i) {
    const Interval between{driven[i].to, driven[i + 1].from};
    if (!only_holes_in(between, windows)) continue;
    BlockedRows these;
    for (const Interval& one : common({between}, pooled)) these.rows_m += one.length();
    for (const HoleRows& rows : rows_)
      if (rows.blocks && rows.rows.from <= between.to && rows.rows.to >= between.from)
        these.longer_m = std::max(these.longer_m, longer_round(*rows.hole));
    blocked.push_back(these);
  }
  double sum = 0;
  for (const BlockedRows& these : blocked) {
    const double longer_m = these.longer_m / static_cast<double>(blocked.size());
    sum += std::min(cut, terms_.objective.overlap * terms_.width_m * (these.rows_m + longer_m));
  }
  return sum;
}

/// By how much a detour of the strip round the hole, on either side, is longer than its rows: it has to
/// pass the hole's farthest point in those rows by half a width, and it has no more rows for the way there
/// and back than from the ends of its zone.
double StripPassages::longer_round(const Hole& hole) const {
  const double left = left_ + terms_.shift_m + 2 * kNoPiece_m,
               right = right_ - terms_.shift_m - 2 * kNoPiece_m;
  const double turned =
      2 * (terms_.tangent * (hole.box.width() + hole.box.height() + 2 * terms_.width_m) + terms_.shear_m);
  Interval rows = extent_along(*hole.ring, left, right);
  rows = {rows.from + turned + kNoPiece_m, rows.to - turned - kNoPiece_m};
  if (rows.from >= rows.to) return 0;
  const auto zone = std::find_if(zones_.begin(), zones_.end(), [&hole](const DetourZone& one) {
    return contains_point(one.obstacles, hole.box.centre());
  });
  if (zone == zones_.end()) return 0;
  const Farthest far = farthest_across(*hole.ring, rows);
  const auto longer_by = [&](Point past, double aside) {
    const double rise = std::max(0.0, aside + 0.5 * terms_.width_m - terms_.shift_m - kNoPiece_m);
    const double reach =
        2 * terms_.detour_reach_m + kDetourFoot * rise + turned + terms_.width_m * kNoPiece_m;
    double sum = 0;
    for (const double run : {past.y - zone->obstacles.min_y + reach, zone->obstacles.max_y - past.y + reach})
      sum += std::hypot(run, rise) - run;
    return sum;
  };
  return std::min(longer_by(far.left, centre_ - far.left.x), longer_by(far.right, far.right.x - centre_));
}

/// Whether all of the boundary between two pieces is that of holes, of which one is in the way.
bool StripPassages::only_holes_in(const Interval& between, const std::vector<BoundaryWindow>& windows) const {
  int edges = 0, parts = 0;
  bool blocked = false;
  for (const HoleRows& rows : rows_) {
    if (rows.rows.from > between.to || rows.rows.to < between.from) continue;
    edges += rows.edges;
    blocked = blocked || rows.blocks;
  }
  for (const BoundaryWindow& window : windows)
    for (const BoundaryPart& part : window.parts)
      parts += part.lowest() <= between.to + terms_.shear_m && part.highest() >= between.from - terms_.shear_m
                   ? 1
                   : 0;
  return blocked && parts == edges;
}

}  // namespace tramline
