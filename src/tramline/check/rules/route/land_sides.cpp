#include "tramline/check/rules/route/land_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "tramline/check/turning/driven_machine.h"
#include "tramline/check/turning/shortest_ways.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

/// Room is looked at to less than this, m.
constexpr double kRoomFoundTo_m = 0.05;
constexpr double kTurnsAtMost = 0.5;
constexpr double kSideways = 1e-6;
constexpr double kKink = 1e-6, kSharperShare = 1e-6;
/// Lines that turn by no more than rounding, as a sine.
constexpr double kStraight = 1e-9;
constexpr double kEnough_m = 1e-6;
constexpr double kFoundTo_s = 0.02, kFoundToShare = 0.001;
constexpr double kSmallest_m = 0.01;
/// Where so many parts do not tell, as with speeds that no machine has, what they are known to take counts.
constexpr int kMostParts = 20000;

/// The corners of the convex hull, anticlockwise, by going round it (Jarvis 1973).
Ring corners_of_hull(const Ring& ring) {
  const auto lower = [](Point a, Point b) { return a.y < b.y || (a.y == b.y && a.x < b.x); };
  const Point first = *std::ranges::min_element(ring, lower);
  Ring out;
  for (Point at = first; out.size() <= ring.size();) {
    out.push_back(at);
    Point next = at;
    for (const Point p : ring) {
      const double side = cross(next - at, p - at);
      if (next == at || side < 0 || (side == 0 && distance(at, p) > distance(at, next))) next = p;
    }
    if (next == first) break;
    at = next;
  }
  return out;
}

/// A line or arc of the axle's line.
struct Piece {
  double length_m = 0;
  double curvature = 0;
};

/// While the implement works the path, in the order in which they are backed along.
std::vector<Piece> pieces_from(const WorkedCourse& course, double sense) {
  const double begin_m = course.ahead_m(), end_m = course.ahead_m() + course.length_m();
  std::vector<Piece> out;
  const auto add = [&](double from_m, double to_m, double curvature) {
    const double length_m = std::min(to_m, end_m) - std::max(from_m, begin_m);
    if (length_m > 0) out.push_back({length_m, curvature});
  };
  constexpr double kBeyond_m = std::numeric_limits<double>::infinity();
  add(-kBeyond_m, 0, 0);
  double at_m = 0;
  for (const PathSegment& segment : course.line().path()) {
    add(at_m, at_m + length(segment), segment.straight() ? 0 : segment.curvature);
    at_m += length(segment);
  }
  add(at_m, kBeyond_m, 0);
  if (sense < 0) std::ranges::reverse(out);
  return out;
}

/// Distances backed, out of one line and into the other.
struct Distances {
  double out_m = 0, in_m = 0;
};
struct Range {
  Distances least, most;
  bool out = false, in = false;
  double together_m = 0;  ///< both at least
  double at_least_s = 0;
};
struct Later {
  bool operator()(const Range& a, const Range& b) const { return a.at_least_s > b.at_least_s; }
};

struct Asked {
  std::optional<double> back_m{};
  double instead_m = kNever_s;  ///< or at both ends together
};

/// Ways that head for a side where they end as well may never turn away from it, if they end nearer to it.
Asked asked(const WayEnd& end, const WayEnd& other) {
  Asked out;
  for (const SideAhead& side : end.sides) {
    const double arrives = dot(other.off, side.inwards) + other.turns;
    if (arrives > 0) {
      const double nearer_m = dot(end.at.at - other.at.at, side.inwards);
      if (nearer_m >= 0) continue;
      const double leaves = end.turns - dot(end.off, side.inwards);
      out.instead_m = std::min(out.instead_m, -nearer_m / std::max(arrives, leaves));
    }
    out.back_m = std::max(out.back_m.value_or(0), side.back_m);
  }
  return out;
}

/// The least of ways that back out and in by distances in some ranges, the most promising split first.
struct Search {
  const Turning& turning;
  double radius_m;
  const WayEnd& from;
  const WayEnd& to;
  std::priority_queue<Range, std::vector<Range>, Later> open{};
  double found_s = kNever_s;

  double forward_m(const Range& range, const Distances& at) const {
    const double lift_m = range.out ? 0 : turning.lift_m, lower_m = range.in ? 0 : turning.lower_m;
    const Pose begins = moved_on(from.backed(at.out_m), lift_m),
               ends = moved_on(to.backed(at.in_m), -lower_m);
    return lift_m + lower_m + least_forward_m(begins, ends, radius_m);
  }

  double seconds(const Range& range, const Distances& at, double ahead_m) const {
    const int changes = range.out && range.in && ahead_m > 0 ? 4 : range.out || range.in ? 2 : 0;
    return changes * turning.gear_change_s +
           std::max(at.out_m + at.in_m, range.together_m) / turning.reverse_speed_mps +
           std::max(0.0, ahead_m) / turning.turning_speed_mps;
  }

  /// Where it backed less far, the machine could come forward to from farther back.
  void push(Range range) {
    if (range.most.out_m + range.most.in_m < range.together_m) return;
    const double spans_m = range.most.out_m - range.least.out_m + range.most.in_m - range.least.in_m;
    const double farthest_m = forward_m(range, range.most);
    found_s = std::min(found_s, seconds(range, range.most, farthest_m));
    if (range.least.out_m + range.least.in_m >= range.together_m)
      found_s = std::min(found_s, seconds(range, range.least, forward_m(range, range.least)));
    range.at_least_s = seconds(range, range.least, farthest_m - spans_m);
    open.push(range);
  }

  /// All ways that back so far out and in at least, and so far together.
  void push_all(std::optional<double> out_m, std::optional<double> in_m, double together_m) {
    for (const bool out : {false, true})
      for (const bool in : {false, true}) {
        if ((out_m && !out) || (in_m && !in)) continue;
        Range all;
        all.out = out;
        all.in = in;
        all.together_m = together_m;
        if (out) all.least.out_m = out_m.value_or(0), all.most.out_m = from.follows_m;
        if (in) all.least.in_m = in_m.value_or(0), all.most.in_m = to.follows_m;
        if (all.least.out_m <= all.most.out_m && all.least.in_m <= all.most.in_m) push(all);
      }
  }

  double least_s(double known_s) {
    double out_s = found_s;
    for (int parts = 0; !open.empty() && parts < kMostParts; ++parts) {
      const Range range = open.top();
      open.pop();
      out_s = std::min(range.at_least_s, found_s);
      const double out_m = range.most.out_m - range.least.out_m, in_m = range.most.in_m - range.least.in_m;
      const double near_s = std::max(kFoundTo_s, kFoundToShare * found_s);
      if (out_s >= std::min(known_s, found_s - near_s) || std::max(out_m, in_m) < kSmallest_m) break;
      Range near = range, far = range;
      if (out_m > in_m)
        near.most.out_m = far.least.out_m = range.least.out_m + 0.5 * out_m;
      else
        near.most.in_m = far.least.in_m = range.least.in_m + 0.5 * in_m;
      push(near);
      push(far);
    }
    return out_s;
  }
};

}  // namespace

Pose WayEnd::backed(double by_m) const { return pose_of(course->axle(from_m + sense * by_m)); }

std::optional<LandSides> LandSides::of(const Plan& plan) {
  const std::optional<double> beyond_m = land_beyond_m(plan);
  const Turning& turning = plan.machine.turning;
  const bool tows = turning.implement == Coupling::kTowed && turning.drawbar_m > 0;
  if (!beyond_m || turning.reverse || tows) return std::nullopt;
  for (const RouteLeg& leg : plan.route.legs)
    if (leg.missing_m > 0) return std::nullopt;
  return LandSides(plan, *beyond_m);
}

LandSides::LandSides(const Plan& plan, double beyond_m)
    : turning_(plan.machine.turning),
      radius_m_(std::max(plan.machine.radius_m, kLeastRadius_m)),
      reach_m_(0) {
  const double behind_m = turning_.implement_offset_m;
  double to_left_m = 0, to_right_m = 0;
  for (const Side& part : outline_at({{0, 0}, {1, 0}, {-behind_m, 0}, {1, 0}}, plan.machine))
    for (const Point corner : part) {
      to_left_m = std::max(to_left_m, corner.y);
      to_right_m = std::max(to_right_m, -corner.y);
      reach_m_ = std::max(reach_m_, std::abs(corner.x));
    }
  half_m_ = std::min(to_left_m, to_right_m);
  const Ring hull = corners_of_hull(plan.field.outer);
  band_m_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point edge = hull[(i + 1) % hull.size()] - hull[i];
    const Point along = 1 / std::hypot(edge.x, edge.y) * edge, inwards{-along.y, along.x};
    sides_.push_back({hull[i] - beyond_m * inwards, inwards});
    double wide_m = 0;
    for (const Point corner : hull) wide_m = std::max(wide_m, dot(corner - hull[i], inwards));
    if (wide_m + 2 * beyond_m < band_m_) {
      band_m_ = wide_m + 2 * beyond_m;
      band_ = along;
    }
  }
}

double LandSides::missing_m(const HullSide& side, const Pose& at, Point off, Comes comes) const {
  const double towards = -dot(off, side.inwards);
  if (towards <= kSideways) return 0;
  // 1 − cos φ, from the sine.
  const double cosine = std::sqrt(std::max(0.0, 1 - towards * towards));
  const double room_m = dot(at.at - side.on, side.inwards);
  const double nearer_m = radius_m_ * (comes == Comes::kEitherWay ? 1 - cosine : 1 + cosine);
  return std::max(0.0, half_m_ + nearer_m - kRoomFoundTo_m - room_m);
}

/// As far as it follows the line where it is never enough.
double LandSides::far_enough_m(const HullSide& side, const WayEnd& end, Comes comes) const {
  double at_m = 0;
  for (const Piece& piece : pieces_from(*end.course, end.sense)) {
    const double to_m = std::min(at_m + piece.length_m, end.follows_m);
    while (at_m < to_m) {
      const Pose pose = end.backed(at_m);
      const Point off = -end.sense * pose.heading.unit();
      const double missing = missing_m(side, pose, off, comes);
      if (missing <= kEnough_m) return at_m;
      // Backing along an arc brings it nearer to enough by twice the distance at the most.
      const double gains = piece.curvature == 0 ? -dot(off, side.inwards) : 2;
      at_m = gains > 0 ? std::min(to_m, at_m + missing / gains) : to_m;
    }
    if (at_m >= end.follows_m) break;
  }
  return end.follows_m;
}

WayEnd LandSides::end_of_line(const WorkedCourse& course, double from_m, double sense,
                              double straight_on_m) const {
  WayEnd out;
  out.course = course;
  out.from_m = from_m;
  out.sense = sense;
  out.at = out.backed(0);
  const Point heading = out.at.heading.unit();
  out.off = -sense * heading;
  Point before = heading;
  const auto turned = [&](Point ahead, Point from) {
    return dot(ahead, from) > 0 ? std::abs(cross(ahead, from)) : 1;
  };
  double at_m = 0;
  for (const Piece& piece : pieces_from(course, sense)) {
    // A position at a kink itself may be on either side of it; headings turn by nothing within so little.
    constexpr double kJustInside_m = 1e-9;
    const double inside_m = std::min(kJustInside_m, 0.5 * piece.length_m);
    const Point first = out.backed(at_m + inside_m).heading.unit();
    const Point last = out.backed(at_m + piece.length_m - inside_m).heading.unit();
    if (turned(first, before) > kKink) break;
    if (std::abs(piece.curvature) * radius_m_ > 1 + kSharperShare) break;
    if (std::max(turned(first, heading), turned(last, heading)) > kTurnsAtMost) break;
    out.turns = std::max(out.turns, turned(last, heading));
    before = last;
    at_m += piece.length_m;
  }
  out.follows_m = at_m;
  const Pose lifted = moved_on(out.at, -sense * straight_on_m);
  for (const HullSide& side : sides_) {
    if (missing_m(side, lifted, out.off, Comes::kEitherWay) > 0)
      out.sides.push_back({side.inwards, far_enough_m(side, out, Comes::kEitherWay)});
    if (out.turns > kStraight || missing_m(side, lifted, out.off, Comes::kTheFarWay) <= 0) continue;
    const Point either{side.inwards.y, -side.inwards.x};
    out.beside.push_back({side.inwards, dot(out.off, either) > 0 ? either : -1 * either,
                          far_enough_m(side, out, Comes::kTheFarWay)});
  }
  return out;
}

WayEnd LandSides::leaving(const WorkedCourse& course) const {
  return end_of_line(course, course.length_m() + course.ahead_m(), -1, turning_.lift_m);
}

WayEnd LandSides::entering(const WorkedCourse& course) const {
  return end_of_line(course, course.ahead_m(), 1, turning_.lower_m);
}

LandSides::InBand LandSides::in_band(const WayEnd& from, const WayEnd& to) const {
  const double begins = dot(from.off, band_), ends = -dot(to.off, band_);
  const double slant = std::abs(cross(from.off, band_)) + from.turns;
  const double slant_to = std::abs(cross(to.off, band_)) + to.turns;
  if (slant >= 1 || slant_to >= 1) return InBand::kFree;
  const double cosines = std::sqrt(1 - slant * slant) + std::sqrt(1 - slant_to * slant_to);
  const double takes_m = cosines * (radius_m_ + half_m_) - (slant + slant_to) * reach_m_;
  if (band_m_ >= takes_m - kRoomFoundTo_m) return InBand::kFree;
  return (begins > 0) == (ends > 0) ? InBand::kOnward : InBand::kNever;
}

/// Ways that back farther than a line is followed: from there any way, with any changes of gear.
double LandSides::farther_s(const WayEnd& from, const WayEnd& to) const {
  const double fastest_mps = std::max(turning_.turning_speed_mps, turning_.reverse_speed_mps);
  const auto beyond_s = [&](const WayEnd& end, const WayEnd& other) {
    return end.follows_m / turning_.reverse_speed_mps +
           least_with_reversing_m(end.backed(end.follows_m), other.at, radius_m_) / fastest_mps;
  };
  return 2 * turning_.gear_change_s + std::min(beyond_s(from, to), beyond_s(to, from));
}

double LandSides::along_lines_s(const WayEnd& from, const WayEnd& to, double known_s) const {
  const InBand band = in_band(from, to);
  if (band == InBand::kNever) return kNever_s;
  const Asked of_from = asked(from, to), of_to = asked(to, from);
  double back_m = 0;
  if (band == InBand::kOnward) {
    const double sense = dot(from.off, band_) > 0 ? 1 : -1;
    back_m = std::max(0.0, sense * dot(from.at.at - to.at.at, band_));
  }
  Search search{turning_, radius_m_, from, to};
  search.push_all(of_from.back_m, of_to.back_m, back_m);
  const double instead_m = std::min(of_from.instead_m, of_to.instead_m);
  if (instead_m < kNever_s) search.push_all({}, {}, std::max(back_m, instead_m));
  return search.least_s(known_s);
}

/// The least of ways whose ends come parallel to a side with the same heading u: so a way begins by turning
/// to u and ends by turning from −u, with half a turn between on the one or on the other side. It is as long
/// as these turns at least, and as what is left to drive once they are driven, straight: the headings of
/// turns at radius r add up to r times the difference of their normals.
double LandSides::loops_s(const WayEnd& from, const WayEnd& to, double enough_s) const {
  const double off_line_m = turning_.lift_m + turning_.lower_m;
  double out_s = 0;
  for (const SideBeside& one : from.beside)
    for (const SideBeside& other : to.beside) {
      if (!(one.inwards == other.inwards) || dot(one.parallel, other.parallel) < 0) continue;
      const Point u = one.parallel, n = one.inwards;
      const Point leads = moved_on(to.at, -turning_.lower_m).at - moved_on(from.at, turning_.lift_m).at;
      // A turn of less than half a circle from one heading to another leads to where the difference of the
      // headings, turned by a quarter of a circle, does.
      const auto turn = [&](Point a, Point b) {
        const double sense = cross(a, b) >= 0 ? 1 : -1;
        const Point c = b - a;
        return radius_m_ * sense * Point{c.y, -c.x};
      };
      const Point arrives = -1 * to.off;
      const Point ends = turn(from.off, u) + turn(-1 * u, arrives);
      const double half_m = 2 * radius_m_;  // across, on the side of the land or on that of its edge
      const double left_m = std::min(distance(leads, ends + half_m * n), distance(leads, ends - half_m * n));
      const double angles =
          std::acos(std::min(1.0, dot(from.off, u))) + std::acos(std::min(1.0, dot(to.off, u)));
      const double loop_m = radius_m_ * (angles + std::numbers::pi) + left_m;
      const double slower = std::max(0.0, 1 / turning_.turning_speed_mps - 1 / turning_.reverse_speed_mps);
      const double backed_m = std::min(one.back_m, from.follows_m) + std::min(other.back_m, to.follows_m);
      const double looping_s =
          std::min((loop_m + off_line_m) / turning_.turning_speed_mps,
                   2 * turning_.gear_change_s + (loop_m - off_line_m) / turning_.turning_speed_mps -
                       slower * backed_m);
      if (looping_s <= out_s) continue;
      Search search{turning_, radius_m_, from, to};
      search.push_all(one.back_m, {}, 0);
      search.push_all({}, other.back_m, 0);
      out_s = std::max(out_s, std::min(looping_s, search.least_s(std::min(enough_s, looping_s))));
    }
  return out_s;
}

double LandSides::least_s(const WayEnd& from, const WayEnd& to, double known_s, double enough_s) const {
  const bool backs = in_band(from, to) != InBand::kFree || asked(from, to).back_m || asked(to, from).back_m;
  if (!backs && (from.beside.empty() || to.beside.empty())) return known_s;
  const double beyond_s = farther_s(from, to);
  if (beyond_s <= known_s) return known_s;
  enough_s = std::min(beyond_s, enough_s);
  double out_s = std::max(known_s, loops_s(from, to, enough_s));
  if (backs && out_s < enough_s) out_s = std::max(out_s, along_lines_s(from, to, enough_s));
  return std::max(known_s, std::min(beyond_s, out_s));
}

}  // namespace tramline::check
