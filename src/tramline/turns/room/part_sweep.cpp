#include "tramline/turns/room/part_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/turns/outline/tolerances.h"

namespace tramline {
namespace {

/// Whether the segment from a along the vector meets the box, by cutting it with one slab after the other
/// (Liang and Barsky 1984).
bool segment_meets(const Box& box, Point a, Point along) {
  double from = 0, to = 1;
  const auto cut = [&](double at, double step, double low, double high) {
    if (step == 0) return low <= at && at <= high;
    const double one = (low - at) / step, other = (high - at) / step;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    return from <= to;
  };
  return cut(a.x, along.x, box.min_x, box.max_x) && cut(a.y, along.y, box.min_y, box.max_y);
}

Point across_axis(Point p) { return {p.x, -p.y}; }

/// A motion whose turning takes no corner farther aside, m, counts as straight: less than what is rounded
/// away of coordinates says nothing about where its centre is.
constexpr double kNoTurn_m = 1e-9;

double turn_of(const Box& part, const EvenMotion& motion) {
  const double turn = std::abs(motion.turn_rad);
  return turn * (farthest_corner_m(part) + std::abs(motion.way_m)) < kNoTurn_m ? 0 : turn;
}

}  // namespace

PartSweep::PartSweep(const Box& part, const EvenMotion& motion)
    : mirrored_(motion.turn_rad < 0),
      way_(motion.way_m),
      turn_(turn_of(part, motion)),
      part_(mirrored_ ? Box{part.min_x, -part.max_y, part.max_x, -part.min_y} : part),
      swept_(part_),
      moved_(displacement({motion.start, way_, turn_})),
      cos_(turn_ > 0 ? std::cos(turn_) : 1),
      sin_(turn_ > 0 ? std::sin(turn_) : 0) {
  assert(!part.empty());
  swept_.min_x += std::min(0.0, way_);
  swept_.max_x += std::max(0.0, way_);
  if (turn_ == 0) return;
  highest_ = -std::numeric_limits<double>::infinity();
  for (const Point corner : corners_of(part_)) {
    if (corners_ > 0 && corner == corner_ways_[corners_ - 1].from) continue;
    if (corners_ > 1 && (corner == corner_ways_[0].from || corner == corner_ways_[1].from)) continue;
    corner_ways_[corners_] = way(corner, 1);
    highest_ = std::max(highest_, corner_ways_[corners_].level);
    ++corners_;
  }
  // f grows with the distance from the centre of the circles
  lowest_ =
      level({std::clamp(0.0, part_.min_x, part_.max_x), std::clamp(way_ / turn_, part_.min_y, part_.max_y)});
}

PartSweep::Way PartSweep::way(Point p, double side) const {
  Point to;
  if (side > 0) {
    to = Point{cos_ * p.x - sin_ * p.y, sin_ * p.x + cos_ * p.y} + moved_;
  } else {
    const Point q = p - moved_;
    to = {cos_ * q.x + sin_ * q.y, cos_ * q.y - sin_ * q.x};
  }
  const Point velocity{way_ - turn_ * p.y, turn_ * p.x};
  return {p, to - p, level(p), dot(velocity, velocity), side};
}

bool PartSweep::meets(Point a, Point b) const {
  if (mirrored_) {
    a = across_axis(a);
    b = across_axis(b);
  }
  const Point along = b - a;
  if (turn_ == 0) return segment_meets(swept_, a, along);
  if (!levels_meet(a, along)) return false;
  if (segment_meets(part_, a, along)) return true;
  for (std::size_t i = 0; i < corners_; ++i)
    if (crosses(corner_ways_[i], a, along)) return true;
  if (const double f = level(a); f < lowest_ || f > highest_) return false;
  const Way back = way(a, -1);
  const std::size_t sides = corners_ == 2 ? 1 : corners_;
  for (std::size_t i = 0; i < sides; ++i) {
    const Point corner = corner_ways_[i].from;
    if (crosses(back, corner, corner_ways_[(i + 1) % corners_].from - corner)) return true;
  }
  return false;
}

/// Whether some f of the edge is one of the part's. Along a line f is convex.
bool PartSweep::levels_meet(Point a, Point along) const {
  const double at_a = level(a), at_b = level(a + along);
  if (std::max(at_a, at_b) < lowest_) return false;
  if (std::min(at_a, at_b) <= highest_) return true;
  const double square = dot(along, along);
  if (!(square > 0)) return false;
  const double foot = (way_ * along.y / turn_ - dot(a, along)) / square;
  return foot > 0 && foot < 1 && level(a + foot * along) <= highest_;
}

/// Whether the way meets the segment: where f takes the way's value, if that is on the way.
bool PartSweep::crosses(const Way& way, Point a, Point along) const {
  const double square = 0.5 * turn_ * dot(along, along);
  const double linear = turn_ * dot(a, along) - way_ * along.y;
  const double constant = level(a) - way.level;
  const double at_end = square + linear + constant;
  if (constant < 0 && at_end < 0) return false;
  if (constant > 0 && at_end > 0 && (linear >= 0 || -linear >= 2 * square)) return false;
  const double discriminant = linear * linear - 4 * square * constant;
  if (discriminant < 0) return false;
  const double sum = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
  const auto meets_at = [&](double share) {
    return share >= 0 && share <= 1 && passes(way, a + share * along);
  };
  return (sum != 0 && meets_at(constant / sum)) || (square > 0 && meets_at(sum / square));
}

/// Whether a point of the circle, or line, along which the way leads is on the way.
bool PartSweep::passes(const Way& way, Point on_circle) const {
  const Point from_start = on_circle - way.from;
  const double beside = cross(way.chord, from_start);
  if (turn_ >= 2 * std::numbers::pi) return true;
  if (turn_ >= kNearlyStraight_rad) return way.side * beside <= 0;
  // The other side of the circle is at least 1.8 radii away, and a radius is speed/ω.
  const double along = dot(way.chord, from_start);
  const double chord_2 = dot(way.chord, way.chord);
  return along >= 0 && along <= chord_2 && turn_ * turn_ * beside * beside <= way.speed_2 * chord_2;
}

}  // namespace tramline
