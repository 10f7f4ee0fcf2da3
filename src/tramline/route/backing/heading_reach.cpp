#include "tramline/route/backing/heading_reach.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <deque>
#include <numbers>
#include <utility>

#include "tramline/geometry/polygon/bounding_rectangle.h"

namespace tramline {
namespace {

/// More than the verifier allows for, m: what the outline may be off the land, places off a line, and the
/// half width of the place where it begins.
constexpr double kOffLand_m = 0.1, kOffLine_m = 0.1, kBegin_m = 0.02;
/// Polygons grow by more than this, m, or not at all.
constexpr double kGrown_m = 1e-6;
/// Edges shorter than this have no reliable direction, m.
constexpr double kEdge_m = 1e-6;
/// Where the machine gets to so many sectors it can turn round; then, or where places have grown so often, it
/// is not followed any more.
constexpr std::size_t kMostSectors = 60, kMostSteps = 2500;

constexpr double kSector = 2 * std::numbers::pi / kHeadingSectors;

Point heading_at(double sectors) { return {std::cos(sectors * kSector), std::sin(sectors * kSector)}; }

/// In sectors, from 0.
double sectors_of(const Pose& pose) {
  const Point heading = pose.heading.unit();
  const double angle = std::atan2(heading.y, heading.x);
  return (angle < 0 ? angle + 2 * std::numbers::pi : angle) / kSector;
}

/// The sector of a heading, and the one beside it if the heading bounds it.
std::array<std::size_t, 2> sectors_at(const Pose& pose) {
  constexpr double kBound = 1e-6;  // of a sector
  const double at = sectors_of(pose) + kHeadingSectors;
  return {static_cast<std::size_t>(at - kBound) % kHeadingSectors,
          static_cast<std::size_t>(at + kBound) % kHeadingSectors};
}

std::size_t after(std::size_t sector) { return (sector + 1) % kHeadingSectors; }
std::size_t before(std::size_t sector) { return (sector + kHeadingSectors - 1) % kHeadingSectors; }

/// The part of a convex polygon in a half plane (Sutherland and Hodgman 1974).
Ring cut(Ring ring, Point at, Point inwards) {
  if (std::ranges::all_of(ring, [&](Point p) { return dot(p - at, inwards) >= 0; })) return ring;
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    const double begins = dot(from - at, inwards), ends = dot(to - at, inwards);
    if (begins >= 0) out.push_back(from);
    if ((begins < 0) != (ends < 0)) out.push_back(from + begins / (begins - ends) * (to - from));
  }
  return out;
}

Ring hull_of_both(const Ring& a, const Ring& b) {
  std::vector<Point> all(a);
  all.insert(all.end(), b.begin(), b.end());
  return hull_of(std::move(all));
}

bool holds(const Ring& ring, Point p) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point edge = ring[(i + 1) % ring.size()] - ring[i];
    if (cross(edge, p - ring[i]) < -kGrown_m * std::hypot(edge.x, edge.y)) return false;
  }
  return ring.size() > 2;
}

/// Whether the places did grow.
bool grow(Ring& places, const Ring& more) {
  if (std::ranges::all_of(more, [&](Point p) { return holds(places, p); })) return false;
  Ring grown = hull_of_both(places, more);
  if (grown == places) return false;
  places = std::move(grown);
  return true;
}

/// Whether a line along an edge of one of two convex polygons separates them. Segments and points are such.
bool apart(const Ring& a, const Ring& b) {
  const auto beyond = [](const Ring& ring, const Ring& other) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point edge = ring[(i + 1) % ring.size()] - ring[i];
      const double length_m = std::hypot(edge.x, edge.y);
      if (length_m < kEdge_m) continue;
      if (std::ranges::all_of(other,
                              [&](Point p) { return cross(edge, p - ring[i]) < -kOffLine_m * length_m; }))
        return true;
    }
    return false;
  };
  return beyond(a, b) || beyond(b, a);
}

/// Whether one of the places may be on the chord and point as the pose does.
bool may_point_on(const Ring& chord, const Pose& pose, const PlacesByHeading& places) {
  return std::ranges::any_of(sectors_at(pose), [&](std::size_t sector) {
    const Ring& there = places.places[sector];
    return !there.empty() && !apart(there, chord);
  });
}

/// Directions in which a machine drives that keeps to a sector of headings.
struct Ways {
  Point low, high;   ///< unit vectors
  double far_m = 0;  ///< as far as it needs to be followed
};

/// Adds corners of where it gets to from a polygon if it drives so far at least. Of those far off, beyond the
/// land, the outermost on either side are enough.
void add_moved(std::vector<Point>& to, const Ring& from, const Ways& ways, double least_m) {
  if (from.empty()) return;
  for (const Point p : from) {
    to.push_back(p + least_m * ways.low);
    if (least_m > 0) to.push_back(p + least_m * ways.high);
  }
  const Point rightmost = *std::ranges::min_element(from, {}, [&](Point p) { return cross(ways.low, p); });
  const Point leftmost = *std::ranges::max_element(from, {}, [&](Point p) { return cross(ways.high, p); });
  to.push_back(rightmost + ways.far_m * ways.low);
  to.push_back(leftmost + ways.far_m * ways.high);
}

}  // namespace

bool may_meet(const PlacesByHeading& a, const PlacesByHeading& b) {
  if (!a.followed || !b.followed) return true;
  for (std::size_t sector = 0; sector < kHeadingSectors; ++sector)
    if (!a.on_land[sector].empty() && !b.on_land[sector].empty() &&
        !apart(a.on_land[sector], b.on_land[sector]))
      return true;
  return false;
}

bool may_meet(const PlacesByHeading& places, const SteeredPath& line) {
  if (!places.followed) return true;
  constexpr double kArc = 0.5;  // of a sector: so much of an arc is looked at as its chord
  for (const SteeredStretch& stretch : line) {
    if (stretch.clothoid()) return true;
    const double turned = std::abs(stretch.curvature_at_start) * stretch.length_m;
    const int parts = 1 + static_cast<int>(turned / (kArc * kSector));
    for (int part = 0; part < parts; ++part) {
      const double step_m = stretch.length_m / parts;
      const Pose from = pose_after(stretch, part * step_m),
                 to = pose_after(stretch, std::min(stretch.length_m, (part + 1) * step_m));
      const Ring chord{from.at, to.at};
      if (may_point_on(chord, from, places) || may_point_on(chord, to, places)) return true;
    }
  }
  return false;
}

bool may_meet(const PlacesByHeading& places, const Pose& pose) {
  return !places.followed || may_point_on({pose.at}, pose, places);
}

HeadingReach::HeadingReach(std::vector<Side> sides, const std::vector<Point>& corners, double radius_m)
    : sides_(std::move(sides)), radius_m_(radius_m) {
  assert(radius_m > 0 && !sides_.empty() && !corners.empty());
  for (const Side& side : sides_) far_m_ = std::max(far_m_, 4 * distance(side.at, sides_.front().at));
  double reach_m = 0;
  for (const Point corner : corners) reach_m = std::max(reach_m, std::hypot(corner.x, corner.y));
  far_m_ += 4 * reach_m;
  // By how much the outline, turned, sticks out of the axle towards a side.
  const auto sticks_out_m = [&](Point heading, const Side& side) {
    double out_m = -reach_m;
    for (const Point corner : corners)
      out_m = std::max(out_m, -dot(corner.x * heading + corner.y * left_of(heading), side.inwards));
    return out_m - kOffLand_m;
  };
  for (std::size_t sector = 0; sector < kHeadingSectors; ++sector) {
    const auto at = static_cast<double>(sector);
    at_bound_m_.emplace_back();
    in_sector_m_.emplace_back();
    for (const Side& side : sides_) {
      at_bound_m_.back().push_back(sticks_out_m(heading_at(at), side));
      // No corner moves by more than its arc from the middle of the sector.
      in_sector_m_.back().push_back(sticks_out_m(heading_at(at + 0.5), side) - 0.5 * kSector * reach_m);
    }
  }
}

Ring HeadingReach::on_land(Ring places, const std::vector<double>& from_side_m) const {
  for (std::size_t i = 0; i < sides_.size() && !places.empty(); ++i)
    places = cut(std::move(places), sides_[i].at + from_side_m[i] * sides_[i].inwards, sides_[i].inwards);
  return places;
}

bool HeadingReach::stands_on_land(Point at, std::size_t bound) const {
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (dot(at - sides_[i].at, sides_[i].inwards) < at_bound_m_[bound][i] + kGrown_m) return false;
  return true;
}

HeadingReach::AtBound HeadingReach::turned(const AtBound& from, double sense, Turn turn) const {
  const std::size_t next = turn == Turn::kLeft ? after(from.bound) : before(from.bound);
  const Point along = heading_at(static_cast<double>(from.bound)) + heading_at(static_cast<double>(next));
  return {from.at + sense * radius_m_ * std::tan(0.5 * kSector) * along, next};
}

bool HeadingReach::can_circle(AtBound from, double sense, Turn turn) const {
  for (std::size_t i = 0; i < kHeadingSectors; ++i) {
    if (!stands_on_land(from.at, from.bound)) return false;
    from = turned(from, sense, turn);
  }
  return true;
}

bool HeadingReach::can_circle_ahead(const AtBound& from, double sense) const {
  constexpr int kRadiiAhead = 4;
  const Point ahead = sense * radius_m_ * heading_at(static_cast<double>(from.bound));
  for (int radii = 0; radii <= kRadiiAhead; ++radii) {
    const AtBound there{from.at + radii * ahead, from.bound};
    if (can_circle(there, sense, Turn::kLeft) || can_circle(there, sense, Turn::kRight)) return true;
  }
  return false;
}

bool HeadingReach::can_turn_round(const Pose& pose, double sense) const {
  const double begins = sectors_of(pose);
  for (const Turn turn : {Turn::kLeft, Turn::kRight}) {
    const double bound = turn == Turn::kLeft ? std::ceil(begins) : std::floor(begins);
    const double to_bound = std::abs(bound - begins) * kSector;
    AtBound place{
        pose.at + sense * radius_m_ * std::tan(0.5 * to_bound) * (pose.heading.unit() + heading_at(bound)),
        static_cast<std::size_t>(bound) % kHeadingSectors};
    for (std::size_t i = 0; i < kHeadingSectors && stands_on_land(place.at, place.bound); ++i) {
      if (can_circle_ahead(place, sense)) return true;
      place = turned(place, sense, turn);
    }
  }
  return false;
}

PlacesByHeading HeadingReach::from(const Pose& pose, double sense) const {
  if (!can_turn_round(pose, sense)) return followed_from(pose, sense);
  // What following it would find in the end.
  PlacesByHeading out;
  out.followed = false;
  return out;
}

PlacesByHeading HeadingReach::followed_from(const Pose& pose, double sense) const {
  PlacesByHeading out;
  out.places.resize(kHeadingSectors);
  out.on_land.resize(kHeadingSectors);
  const std::array<std::size_t, 2> first = sectors_at(pose);
  const auto begins_in = [&](std::size_t sector) { return sector == first[0] || sector == first[1]; };
  const Ring start{pose.at + Point{-kBegin_m, -kBegin_m}, pose.at + Point{kBegin_m, -kBegin_m},
                   pose.at + Point{kBegin_m, kBegin_m}, pose.at + Point{-kBegin_m, kBegin_m}};
  // Places where it passes the lower bound of a sector, turning to the left and to the right.
  std::vector<Ring> leftwards(kHeadingSectors), rightwards(kHeadingSectors);
  const auto ways_in = [&](std::size_t sector) {
    const auto at = static_cast<double>(sector);
    return Ways{sense * heading_at(at), sense * heading_at(at + 1), far_m_};
  };
  // Along the bounds of a sector, so that it is 2 r sin(δ/2) along the middle.
  const double through_m = 2 * radius_m_ * std::tan(0.5 * kSector);
  std::deque<std::size_t> changed{first[0]};
  if (first[1] != first[0]) changed.push_back(first[1]);
  std::vector<bool> seen(kHeadingSectors, false);
  std::size_t sectors = 0, steps = 0;
  for (; !changed.empty(); ++steps) {
    const std::size_t sector = changed.front();
    changed.pop_front();
    if (!seen[sector]) ++sectors;
    seen[sector] = true;
    if (sectors > kMostSectors || steps > kMostSteps) {
      out.followed = false;
      return out;
    }
    const Ring &low = leftwards[sector], &high = rightwards[after(sector)];
    const Ways ways = ways_in(sector);
    const auto pass = [&](Ring& places, std::size_t bound, const Ring& through, const Ring& back) {
      std::vector<Point> more;
      add_moved(more, through, ways, through_m);
      add_moved(more, back, ways, 0);
      if (begins_in(sector)) add_moved(more, start, ways, 0);
      const Ring there = on_land(hull_of(std::move(more)), at_bound_m_[bound]);
      return !there.empty() && grow(places, there);
    };
    const auto queue = [&](std::size_t next) {
      if (std::ranges::find(changed, next) == changed.end()) changed.push_back(next);
    };
    if (pass(leftwards[after(sector)], after(sector), low, high)) queue(after(sector));
    if (pass(rightwards[sector], sector, high, low)) queue(before(sector));
  }
  for (std::size_t sector = 0; sector < kHeadingSectors; ++sector) {
    if (!seen[sector]) continue;
    std::vector<Point> all;
    for (const Ring* from : {&leftwards[sector], &rightwards[after(sector)]})
      add_moved(all, *from, ways_in(sector), 0);
    if (begins_in(sector)) add_moved(all, start, ways_in(sector), 0);
    out.places[sector] = hull_of(std::move(all));
    out.on_land[sector] = on_land(out.places[sector], in_sector_m_[sector]);
  }
  return out;
}

}  // namespace tramline
