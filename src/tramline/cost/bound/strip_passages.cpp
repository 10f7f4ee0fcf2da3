#include "tramline/cost/bound/strip_passages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/cost/bound/joined_intervals.h"
#include "tramline/cost/bound/vacated_land.h"
#include "tramline/cost/tolerances.h"

namespace tramline {
namespace {

/// A ring of fewer corners is not gone round as a circle, whose middle is no farther from that of its box, as
/// a share of its size.
constexpr std::size_t kFewestOfCircle = 8;
constexpr double kOffCircle_share = 0.05;

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

/// The corners of a ring in some rows, and the points where it enters and leaves them.
std::vector<Point> corners_in(const Ring& ring, const Interval& rows) {
  std::vector<Point> out;
  Point a = ring.back();
  for (const Point b : ring) {
    const Point from = a;
    a = b;
    if (std::max(from.y, b.y) < rows.from || std::min(from.y, b.y) > rows.to) continue;
    for (const Point end : {from, b}) {
      const double y = std::clamp(end.y, rows.from, rows.to);
      out.push_back({from.y == b.y ? end.x : from.x + (b.x - from.x) * ((y - from.y) / (b.y - from.y)), y});
    }
  }
  return out;
}

/// The least length of track over which a path comes back to it, from `aside_m` beside it and along an arc.
double least_way_back(double aside_m, double arc_m) {
  return aside_m < arc_m ? std::sqrt(aside_m * (2 * arc_m - aside_m)) : arc_m;
}

}  // namespace

/// Makes it the way round another obstacle as well.
void StripPassages::Way::meet(const Way& other) {
  const double longest_m = std::max(longer_m, other.longer_m);
  const bool both_fit = fits && other.fits;
  *this = other;
  longer_m = longest_m;
  fits = both_fit;
}

StripPassages::StripPassages(const TurnedSubfield& subfield, const std::vector<DetourZone>& zones,
                             const PassageTerms& terms)
    : zones_(zones), terms_(terms) {
  const Box near = subfield.reach.grown(terms.width_m + terms.shift_m);
  for (const Polygon& obstacle : subfield.ground.hard) {
    const Box box = bounds(obstacle);
    if (intersects(box, near)) obstacles_.push_back({&obstacle.outer, box});
  }
}

std::optional<StripPassages::ObstacleRows> StripPassages::rows_of(const Obstacle& obstacle) const {
  const double touch = terms_.shift_m + kWidthTolerance, inner = terms_.shift_m + 2 * kNoPiece_m;
  if (obstacle.box.min_x > right_ + touch || obstacle.box.max_x < left_ - touch) return std::nullopt;
  Interval rows = extent_along(*obstacle.ring, left_ - touch, right_ + touch);
  if (rows.from > rows.to) return std::nullopt;
  rows.from -= terms_.shear_m + kWidthTolerance;
  rows.to += terms_.shear_m + kWidthTolerance;
  const bool blocks = obstacle.box.min_x < right_ - inner && obstacle.box.max_x > left_ + inner;
  return ObstacleRows{rows, blocks, &obstacle};
}

Intervals StripPassages::enter(const StripGrid& grid, int strip) {
  left_ = grid.line(strip);
  right_ = left_ + terms_.width_m;
  centre_ = grid.centre(strip);
  rows_.clear();
  Intervals all;
  for (const Obstacle& obstacle : obstacles_) {
    const std::optional<ObstacleRows> rows = rows_of(obstacle);
    if (!rows) continue;
    rows_.push_back(*rows);
    all.push_back(rows->rows);
  }
  return joined(std::move(all));
}

double StripPassages::cost(const Intervals& driven, const Intervals& zones, const Intervals& pooled,
                           const std::vector<BoundaryWindow>& windows) const {
  const Objective& price = terms_.objective;
  const Interval land = land_in(windows);
  thread_local std::vector<Passage> passages;
  passages.clear();
  for (std::size_t i = 0; i + 1 < driven.size(); ++i) {
    const Interval between{driven[i].to, driven[i + 1].from};
    // Beyond a zone the pieces may be told apart by the land between them, and then pay their turns anyway.
    if (!blocks_within(between.from, between.to) || !without({between}, zones).empty()) continue;
    const bool stops = only_obstacles_in(between.from, between.to, windows);
    Passage passage;
    passage.cut = price.turn + (stops ? 2 * price.stop : 0);
    for (const Interval& one : common({between}, pooled)) passage.rows_m += one.length();
    const Interval piece{driven[i].from, driven[i + 1].to};
    int met = 0;
    for (const ObstacleRows& rows : rows_) {
      if (rows.rows.from < between.from || rows.rows.to > between.to) continue;
      ++met;
      if (!rows.blocks) continue;
      const WaysRound ways = ways_round(*rows.obstacle, piece, land);
      passage.ways.left.meet(ways.left);
      passage.ways.right.meet(ways.right);
      passage.alone = &rows;
    }
    if (met != 1 || !is_alone(*passage.alone)) passage.alone = nullptr;
    passages.push_back(passage);
  }
  double sum = 0;
  for (const Passage& passage : passages) {
    double least = passage.cut;
    for (const Way* way : {&passage.ways.left, &passage.ways.right}) {
      if (!way->fits) continue;
      const double longer_m = way->longer_m / static_cast<double>(passages.size());
      double round = price.overlap * terms_.width_m * (passage.rows_m + longer_m);
      if (round < least && passage.alone) round += (price.overlap + price.uncovered) * vacated(*way, windows);
      least = std::min(least, round);
    }
    sum += least;
  }
  return sum;
}

int StripPassages::stops_at_ends(const Intervals& driven, const std::vector<BoundaryWindow>& windows) const {
  if (driven.empty()) return 0;
  const Interval land = land_in(windows);
  const Interval first = driven.front(), last = driven.back();
  bool below = false, above = false;
  for (const ObstacleRows& one : rows_) {
    if (!one.blocks) continue;
    if (!below && one.rows.to <= first.from && only_obstacles_in(one.rows.from, first.from, windows))
      below = !ways_round(*one.obstacle, first, land).any();
    if (!above && one.rows.from >= last.to && only_obstacles_in(last.to, one.rows.to, windows))
      above = !ways_round(*one.obstacle, last, land).any();
  }
  return (below ? 1 : 0) + (above ? 1 : 0);
}

/// All rows with land in the strip.
Interval StripPassages::land_in(const std::vector<BoundaryWindow>& windows) const {
  double top = windows.front().highest;
  for (const BoundaryWindow& window : windows) top = std::max(top, window.highest);
  return {windows.front().lowest - terms_.shear_m, top + terms_.shear_m};
}

/// Detours of the strip round the obstacle. The obstacle lies on one side of a piece that is driven past all
/// of its rows; else those of its points do that lie in the rows in which it is in the strip. The detour
/// passes each of them by half a width. It has no more rows for the way there and back than from the ends of
/// its zone, and it leaves the track, and is back on it, where there is land in the strip.
StripPassages::WaysRound StripPassages::ways_round(const Obstacle& obstacle, const Interval& piece,
                                                   const Interval& land) const {
  const Box& box = obstacle.box;
  const double left = left_ + terms_.shift_m + 2 * kNoPiece_m,
               right = right_ - terms_.shift_m - 2 * kNoPiece_m;
  const double turned = turned_m(obstacle);
  Interval rows = extent_along(*obstacle.ring, left, right);
  rows = {rows.from + turned + kNoPiece_m, rows.to - turned - kNoPiece_m};
  if (piece.from < box.min_y - turned - kNoPiece_m && piece.to > box.max_y + turned + kNoPiece_m)
    rows = {box.min_y, box.max_y};
  const auto zone = std::find_if(zones_.begin(), zones_.end(), [&box](const DetourZone& one) {
    return contains_point(one.obstacles, box.centre());
  });
  WaysRound out;
  if (rows.from >= rows.to || zone == zones_.end()) return out;
  const auto pass = [&](Point past, double aside, Way& way) {
    const double rise = aside + 0.5 * terms_.width_m - terms_.shift_m - kNoPiece_m;
    if (rise <= 0 || !way.fits) return;
    const double reach =
        2 * terms_.detour_reach_m + kDetourFoot * rise + turned + terms_.width_m * kNoPiece_m;
    double longer_m = 0;
    for (const double run : {past.y - zone->obstacles.min_y + reach, zone->obstacles.max_y - past.y + reach})
      longer_m += std::hypot(run, rise) - run;
    way.longer_m = std::max(way.longer_m, longer_m);
    const double room = std::min(past.y - land.from, land.to - past.y) + turned + kNoPiece_m;
    way.fits = room >= least_way_back(rise, terms_.detour_reach_m);
    if (rise > way.aside_m) {
      way.past = past;
      // A circle is gone round as one, past its middle.
      const bool may_be_round = obstacle.ring->size() >= kFewestOfCircle;
      way.slack_m = turned + kNoPiece_m +
                    (may_be_round ? std::abs(past.y - box.centre().y) + kOffCircle_share * box.height() : 0);
    }
    way.aside_m = std::max(way.aside_m, rise);
  };
  for (const Point past : corners_in(*obstacle.ring, rows)) {
    pass(past, centre_ - past.x, out.left);
    pass(past, past.x - centre_, out.right);
  }
  return out;
}

/// By how much points of an obstacle may lie elsewhere along, and those of the strips near it.
double StripPassages::turned_m(const Obstacle& obstacle) const {
  const Box& box = obstacle.box;
  return 2 * (terms_.tangent * (box.width() + box.height() + 2 * terms_.width_m) + terms_.shear_m);
}

/// Whether no other strip has a detour where this obstacle is: it reaches into no other, in no grid, and no
/// detours round others come so near.
bool StripPassages::is_alone(const ObstacleRows& rows) const {
  const Box& box = rows.obstacle->box;
  const double margin = terms_.shift_m + kWidthTolerance;
  if (box.min_x - margin <= left_ || box.max_x + margin >= right_) return false;
  const auto zone = std::find_if(zones_.begin(), zones_.end(), [&box](const DetourZone& one) {
    return contains_point(one.obstacles, box.centre());
  });
  if (zone == zones_.end() || zone->count != 1) return false;
  const Box strip{left_ - margin, zone->land.min_y - terms_.shear_m, right_ + margin,
                  zone->land.max_y + terms_.shear_m};
  return std::none_of(zones_.begin(), zones_.end(), [&](const DetourZone& one) {
    return &one != &*zone && intersects(one.land.grown(terms_.shift_m + terms_.shear_m), strip);
  });
}

/// Land of the strip that nobody works where its own detour goes this way.
double StripPassages::vacated(const Way& way, const std::vector<BoundaryWindow>& windows) const {
  if (way.aside_m <= 0) return 0;
  Intervals full;
  for (std::size_t i = 0; i + 1 < windows.size(); ++i)
    if (windows[i].inside_after)
      full.push_back({windows[i].highest + terms_.shear_m, windows[i + 1].lowest - terms_.shear_m});
  return vacated_m2({way.past.y, way.aside_m, terms_.detour_reach_m, terms_.width_m, way.slack_m}, full);
}

/// Whether an obstacle is in the way between these coordinates along, in every grid.
bool StripPassages::blocks_within(double from, double to) const {
  return std::any_of(rows_.begin(), rows_.end(), [&](const ObstacleRows& one) {
    return one.blocks && one.rows.from >= from && one.rows.to <= to;
  });
}

/// Whether all of the boundary between these coordinates along has an obstacle beyond it.
bool StripPassages::only_obstacles_in(double from, double to,
                                      const std::vector<BoundaryWindow>& windows) const {
  if (terms_.at_obstacle.empty()) return false;
  for (const BoundaryWindow& window : windows)
    for (const BoundaryPart& part : window.parts)
      if (part.lowest() <= to + terms_.shear_m && part.highest() >= from - terms_.shear_m &&
          !terms_.at_obstacle[part.edge])
        return false;
  return true;
}

}  // namespace tramline
