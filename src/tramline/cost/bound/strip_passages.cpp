#include "tramline/cost/bound/strip_passages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/cost/bound/detour_length.h"
#include "tramline/cost/bound/joined_intervals.h"
#include "tramline/cost/bound/ring_in_strip.h"
#include "tramline/cost/bound/swath_edge.h"
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
    : zones_(zones), terms_(terms), reach_(subfield.reach) {
  const Box near = subfield.reach.grown(terms.width_m + terms.shift_m);
  for (const Polygon& obstacle : subfield.ground.hard) {
    const Box box = bounds(obstacle);
    if (!intersects(box, near)) continue;
    obstacles_.push_back({&obstacle.outer, box});
    const DetourZone* zone = zone_of(obstacles_.back());
    if (zone && zone->count == 1) obstacles_.back().alone = zone;
    obstacles_.back().together = has_no_bays(obstacle.outer);
  }
}

std::optional<StripPassages::ObstacleRows> StripPassages::rows_of(Obstacle& obstacle) const {
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
  for (Obstacle& obstacle : obstacles_) {
    const std::optional<ObstacleRows> rows = rows_of(obstacle);
    if (!rows) continue;
    rows_.push_back(*rows);
    all.push_back(rows->rows);
  }
  return joined(std::move(all));
}

double StripPassages::cost(const Intervals& driven, const Intervals& zones, const Intervals& pooled,
                           const std::vector<BoundaryWindow>& windows) {
  const Objective& price = terms_.objective;
  const Interval land = land_in(windows);
  thread_local std::vector<Passage> passages;
  passages.clear();
  for (std::size_t i = 0; i + 1 < driven.size(); ++i) {
    const Interval between{driven[i].to, driven[i + 1].from};
    // Beyond a zone the pieces may be told apart by the land between them, and then pay their turns anyway.
    if (!without({between}, zones).empty()) continue;
    Passage passage;
    const Interval piece{driven[i].from, driven[i + 1].to};
    int met = 0;
    for (ObstacleRows& rows : rows_) {
      if (rows.rows.from < between.from || rows.rows.to > between.to) continue;
      ++met;
      passage.alone = &rows;
      passage.blocked = passage.blocked || rows.blocks;
      if (!rows.blocks && !rows.obstacle->alone) continue;
      WaysRound ways = ways_round(*rows.obstacle, piece, land);
      passage.ways.left.meet(ways.left);
      passage.ways.right.meet(ways.right);
      passage.ways.passed = std::move(ways.passed);
      passage.ways.in_strip = ways.in_strip;
    }
    if (met == 0) continue;
    if (met != 1 || !passage.alone->obstacle->alone) passage.alone = nullptr;
    if (!passage.alone && !passage.blocked) continue;
    const bool stops = only_obstacles_in(between.from, between.to, windows);
    passage.cut = price.turn + (stops ? 2 * price.stop : 0);
    for (const Interval& one : common({between}, pooled)) passage.rows_m += one.length();
    passages.push_back(std::move(passage));
  }
  // A detour round what stands alone in its zone passes nothing else.
  const auto others = std::count_if(passages.begin(), passages.end(),
                                    [](const Passage& one) { return !one.alone && one.blocked; });
  double sum = 0;
  for (const Passage& passage : passages) {
    if (passage.alone) {
      passage.alone->is_known = true;
      keep(passage, windows);
      continue;
    }
    double least = passage.cut;
    for (const Way* way : {&passage.ways.left, &passage.ways.right})
      if (way->fits)
        least = std::min(least, price.overlap * terms_.width_m *
                                    (passage.rows_m + way->longer_m / static_cast<double>(others)));
    sum += least;
  }
  for (const ObstacleRows& rows : rows_)
    if (!rows.is_known) rows.obstacle->together = false;
  return sum;
}

/// Keeps what the current strip's ways past an obstacle cost for cost_together().
void StripPassages::keep(const Passage& passage, const std::vector<BoundaryWindow>& windows) const {
  Obstacle& obstacle = *passage.alone->obstacle;
  StripAtObstacle strip;
  strip.left = left_;
  strip.blocked = passage.alone->blocks;
  strip.cut = passage.cut;
  const Way* ways[] = {&passage.ways.left, &passage.ways.right};
  for (std::size_t side = 0; side < 2; ++side) {
    const Way& way = *ways[side];
    if (!way.fits) continue;
    strip.ways[side].cost = terms_.objective.overlap * terms_.width_m * (passage.rows_m + way.longer_m);
    if (way.is_farthest && way.aside_m > 0 && terms_.drivable)
      strip.ways[side].place = {way.past.y, way.aside_m, terms_.detour_reach_m, terms_.width_m, way.slack_m};
  }
  for (std::size_t side = 0; side < 2; ++side) strip.ways[side].passed = passage.ways.passed[side];
  strip.in_the_way = passage.ways.in_strip;
  strip.clear = clear_rows(obstacle, windows);
  obstacle.strips.push_back(std::move(strip));
}

double StripPassages::cost_together() const {
  double sum = 0;
  for (const Obstacle& obstacle : obstacles_)
    if (!obstacle.strips.empty()) sum += cost_past(obstacle);
  return sum;
}

/// Of all strips that have been kept.
double StripPassages::cost_past(const Obstacle& obstacle) const {
  const std::vector<StripAtObstacle>& strips = obstacle.strips;
  const Box& box = obstacle.box;
  const double touch = terms_.shift_m + 2 * kWidthTolerance;
  const double left = strips.front().left, right = strips.back().left + terms_.width_m;
  // Strips beyond have no land, or the obstacle does not reach so far.
  const bool whole =
      (left < obstacle.box.min_x - touch || left < reach_.min_x - touch) &&
      (right > obstacle.box.max_x + touch || right > reach_.max_x + touch) &&
      std::abs(right - left - static_cast<double>(strips.size()) * terms_.width_m) < 0.5 * terms_.width_m;
  // Where the obstacle may lie that far elsewhere, next to no land is left for certain.
  constexpr double kMostShift_share = 0.25;  // of the width
  const double shift = shift_at(obstacle);
  const bool together = obstacle.together && whole && shift < kMostShift_share * terms_.width_m &&
                        std::none_of(zones_.begin(), zones_.end(), [&](const DetourZone& one) {
                          return &one != obstacle.alone && comes_near(obstacle, one);
                        });
  if (!together) {
    double sum = 0;
    for (const StripAtObstacle& strip : strips)
      if (strip.blocked) sum += std::min({strip.cut, strip.ways[0].cost, strip.ways[1].cost});
    return sum;
  }
  const double far_m = terms_.detour_reach_m + 0.5 * terms_.width_m + turned_m(obstacle.box);
  const Interval rows{std::max(box.min_y - far_m, obstacle.alone->land.min_y),
                      std::min(box.max_y + far_m, obstacle.alone->land.max_y)};
  return least_cost_past(
      {*obstacle.ring, terms_.width_m, terms_.detour_reach_m, shift + kNoPiece_m,
       turned_m(obstacle.box) + kNoPiece_m, rows, terms_.objective.overlap + terms_.objective.uncovered},
      strips);
}

/// Whether detours round other obstacles may work land of the strips that this one reaches into.
bool StripPassages::comes_near(const Obstacle& obstacle, const DetourZone& other) const {
  const double margin = terms_.shift_m + kWidthTolerance;
  const Box strips{obstacle.strips.front().left - margin, obstacle.alone->land.min_y - terms_.shear_m,
                   obstacle.strips.back().left + terms_.width_m + margin,
                   obstacle.alone->land.max_y + terms_.shear_m};
  return intersects(other.land.grown(terms_.shift_m + terms_.shear_m), strips);
}

/// The rows about an obstacle in which no other boundary is in the current strip.
Interval StripPassages::clear_rows(const Obstacle& obstacle,
                                   const std::vector<BoundaryWindow>& windows) const {
  const double middle = obstacle.box.centre().y, margin = turned_m(obstacle.box) + kNoPiece_m;
  Interval out{obstacle.alone->land.min_y, obstacle.alone->land.max_y};
  for (const BoundaryWindow& window : windows)
    for (const BoundaryPart& part : window.parts) {
      if (!terms_.at_obstacle.empty() && terms_.at_obstacle[part.edge]) continue;
      if (part.lowest() < middle) out.from = std::max(out.from, part.highest() + margin);
      if (part.highest() > middle) out.to = std::min(out.to, part.lowest() - margin);
    }
  return out;
}

/// By how much the obstacle may lie elsewhere across.
double StripPassages::shift_at(const Obstacle& obstacle) const {
  return std::min(terms_.shift_m, most_shift(obstacle.box.min_y, obstacle.box.max_y, terms_.moving));
}

const DetourZone* StripPassages::zone_of(const Obstacle& obstacle) const {
  const auto found = std::find_if(zones_.begin(), zones_.end(), [&](const DetourZone& one) {
    return contains_point(one.obstacles, obstacle.box.centre());
  });
  return found == zones_.end() ? nullptr : &*found;
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

/// The rows in which any detour past a zone lies, on the side on which that reaches so far from the track.
Interval StripPassages::rows_of_detour(const DetourZone& zone, double most_aside_m) const {
  const Box& box = zone.obstacles;
  const double turned = turned_m(box);
  const double aside_m = most_aside_m + 0.5 * terms_.width_m + terms_.shift_m + turned +
                         kDetourRound_share * std::hypot(box.width(), box.height());
  const double reach = rows_to_leave_m(aside_m) + turned + terms_.width_m * kNoPiece_m;
  return {box.min_y - reach, box.max_y + reach};
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
  const double turned = turned_m(obstacle.box), shift = shift_at(obstacle);
  Interval rows = extent_along(*obstacle.ring, left, right);
  rows = {rows.from + turned + kNoPiece_m, rows.to - turned - kNoPiece_m};
  WaysRound out;
  out.in_strip = rows;
  if (obstacle.alone && rows.from < rows.to) {
    // A detour goes round all that is in the way in these rows, and what lies farther to its side.
    out.passed[0] = ends_within(*obstacle.ring, {box.min_x, rows.from, right, rows.to});
    out.passed[1] = ends_within(*obstacle.ring, {left, rows.from, box.max_x, rows.to});
  }
  const bool whole =
      piece.from < box.min_y - turned - kNoPiece_m && piece.to > box.max_y + turned + kNoPiece_m;
  if (whole) rows = {box.min_y, box.max_y};
  const DetourZone* zone = zone_of(obstacle);
  if (rows.from >= rows.to || !zone) return out;
  const auto pass = [&](Point past, double aside, Way& way) {
    const double rise = aside + 0.5 * terms_.width_m - shift - kNoPiece_m;
    if (rise <= 0 || !way.fits) return;
    const double room = std::min(past.y - land.from, land.to - past.y) + turned + kNoPiece_m;
    way.fits = room >= least_way_back(rise, terms_.detour_reach_m);
    if (rise > way.aside_m) {
      way.past = past;
      way.is_farthest = whole;
      // A circle is gone round as one, past its middle.
      const bool may_be_round = obstacle.ring->size() >= kFewestOfCircle;
      way.slack_m = turned + kNoPiece_m +
                    (may_be_round ? std::abs(past.y - box.centre().y) + kOffCircle_share * box.height() : 0);
    }
    way.aside_m = std::max(way.aside_m, rise);
  };
  thread_local std::array<std::vector<SeenPoint>, 2> seen;
  for (std::vector<SeenPoint>& side : seen) side.clear();
  for (const Point past : corners_in(*obstacle.ring, rows)) {
    const double left_m = centre_ - past.x, right_m = past.x - centre_;
    pass(past, left_m, out.left);
    pass(past, right_m, out.right);
    seen[0].push_back({past.y, left_m - shift - kNoPiece_m});
    seen[1].push_back({past.y, right_m - shift - kNoPiece_m});
  }
  // Detours lie in the rows of their zone; they are displaced no farther than half a width beyond all of it.
  const double most_aside[] = {centre_ - zone->obstacles.min_x, zone->obstacles.max_x - centre_};
  Way* ways[] = {&out.left, &out.right};
  for (std::size_t side = 0; side < 2; ++side) {
    if (!ways[side]->fits || ways[side]->aside_m <= 0) continue;
    const double longer_m =
        least_longer_m(seen[side], 0.5 * terms_.width_m, rows_of_detour(*zone, most_aside[side]));
    // Corners may lie elsewhere along, all the more the farther they are apart.
    ways[side]->longer_m = std::max(0.0, longer_m - 2 * turned);
  }
  if (!obstacle.alone || !whole) return out;
  if (out.left.aside_m > 0) out.passed[0].push_back(out.left.past);
  if (out.right.aside_m > 0) out.passed[1].push_back(out.right.past);
  return out;
}

/// No detour that is displaced so far begins farther from what it goes round: by two arcs, or where these do
/// not suffice by a line between them.
double StripPassages::rows_to_leave_m(double aside_m) const {
  const double r = terms_.detour_reach_m;
  return aside_m < 2 * r ? std::sqrt(aside_m * (4 * r - aside_m)) : 2 * r + kDetourFoot * aside_m;
}

/// By how much points of obstacles in a box may lie elsewhere along, and those of the strips near them.
double StripPassages::turned_m(const Box& box) const {
  return 2 * (terms_.tangent * (box.width() + box.height() + 2 * terms_.width_m) + terms_.shear_m);
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
