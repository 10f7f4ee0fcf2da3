#include "tramline/check/rules/route/land_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tramline/check/rules/route/sides_ahead.h"
#include "tramline/check/turning/driven_machine.h"
#include "tramline/check/turning/shortest_ways.h"
#include "tramline/check/turning/turning_ground.h"

namespace tramline::check {
namespace {

/// Room is looked at to less than this, m.
constexpr double kRoomFoundTo_m = 0.05;
constexpr double kSideways = 1e-6;
constexpr double kEnough_m = 1e-6;

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

/// Along pieces of a line, in order, whose poses are told by how far they lie along it.
template <class PoseAt>
std::vector<LineStep> steps_along(const std::vector<LinePiece>& pieces, const PoseAt& pose_at) {
  constexpr double kStep = std::numbers::pi / 72;  // turned by no more
  std::vector<LineStep> out;
  double at_m = 0;
  for (const LinePiece& piece : pieces) {
    const int parts = 1 + static_cast<int>(std::abs(piece.curvature) * piece.length_m / kStep);
    for (int i = 0; i < parts; ++i)
      out.push_back(
          {pose_at(at_m + i * piece.length_m / parts), pose_at(at_m + (i + 1) * piece.length_m / parts)});
    at_m += piece.length_m;
  }
  return out;
}

}  // namespace

std::optional<LandSides> LandSides::of(const Plan& plan) {
  const std::optional<double> beyond_m = land_beyond_m(plan);
  const Turning& turning = plan.machine.turning;
  if (!beyond_m || turning.reverse || tows(turning)) return std::nullopt;
  for (const RouteLeg& leg : plan.route.legs)
    if (leg.missing_m > 0) return std::nullopt;
  return LandSides(plan, *beyond_m);
}

LandSides::LandSides(const Plan& plan, double beyond_m)
    : costs_{plan.machine.turning, plan.route.proof.stop_s + 2 * plan.machine.turning.gear_change_s,
             std::max(plan.machine.radius_m, kLeastRadius_m)} {
  const double behind_m = costs_.turning.implement_offset_m;
  double to_left_m = 0, to_right_m = 0;
  for (const Side& part : outline_at({{0, 0}, {1, 0}, {-behind_m, 0}, {1, 0}}, plan.machine))
    for (const Point corner : part) {
      to_left_m = std::max(to_left_m, corner.y);
      to_right_m = std::max(to_right_m, -corner.y);
      reach_m_ = std::max(reach_m_, std::abs(corner.x));
    }
  half_m_ = std::min(to_left_m, to_right_m);
  front_m_ = rear_m_ = -reach_m_;
  for (const Side& part : outline_at({{0, 0}, {1, 0}, {-behind_m, 0}, {1, 0}}, plan.machine)) {
    const auto [rightmost, leftmost] = std::ranges::minmax(part, {}, &Point::y);
    if (std::min(leftmost.y, -rightmost.y) < half_m_) continue;
    const auto [rearmost, foremost] = std::ranges::minmax(part, {}, &Point::x);
    front_m_ = std::max(front_m_, foremost.x);
    rear_m_ = std::max(rear_m_, -rearmost.x);
  }
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
  const bool stops =
      std::ranges::any_of(plan.route.legs, [](const RouteLeg& leg) { return leg.kind == LegKind::kBackOut; });
  if (!stops) return;
  std::vector<Point> corners;
  for (const Side& part : outline_at({{0, 0}, {1, 0}, {-behind_m, 0}, {1, 0}}, plan.machine))
    corners.insert(corners.end(), part.begin(), part.end());
  std::vector<ConvexLand::Edge> edges;
  for (const HullSide& side : sides_) edges.push_back({side.on, side.inwards});
  land_.emplace(std::move(edges), std::move(corners), costs_.radius_m);
}

double LandSides::missing_m(const HullSide& side, const Pose& at, Point off, Comes comes) const {
  const double towards = -dot(off, side.inwards);
  if (towards <= kSideways) return 0;
  // 1 − cos φ, from the sine.
  const double cosine = std::sqrt(std::max(0.0, 1 - towards * towards));
  const double room_m = dot(at.at - side.on, side.inwards);
  const double nearer_m = costs_.radius_m * (comes == Comes::kEitherWay ? 1 - cosine : 1 + cosine);
  return std::max(0.0, half_m_ + nearer_m - kRoomFoundTo_m - room_m);
}

double LandSides::far_enough_m(const HullSide& side, const WayEnd& end, Comes comes) const {
  double at_m = 0;
  for (const LinePiece& piece : pieces_behind(*end.course, end.sense, end.behind_m)) {
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
  return kNever_s;
}

WayEnd LandSides::way_end(const WorkedCourse& course, double from_m, double sense, double straight_on_m,
                          Followed followed, double behind_m) const {
  WayEnd out;
  out.course = course;
  out.from_m = from_m;
  out.sense = sense;
  out.behind_m = behind_m;
  out.at = out.backed(0);
  out.off = -sense * out.at.heading.unit();
  follow_line(out, costs_.radius_m, followed);
  const Pose lifted = moved_on(out.at, -sense * straight_on_m);
  for (const HullSide& side : sides_) {
    if (missing_m(side, lifted, out.off, Comes::kEitherWay) > 0)
      out.sides.push_back({side.inwards, far_enough_m(side, out, Comes::kEitherWay)});
    if (out.turns > kTurnsByRounding) continue;
    const Point either{side.inwards.y, -side.inwards.x};
    const Point parallel = dot(out.off, either) > 0 ? either : -1 * either;
    if (std::abs(dot(out.off, side.inwards)) <= kSideways)
      out.beside.push_back({side.inwards, parallel, 0, kNever_s});
    else if (missing_m(side, lifted, out.off, Comes::kTheFarWay) > 0)
      out.beside.push_back({side.inwards, parallel, std::acos(std::min(1.0, dot(out.off, parallel))),
                            far_enough_m(side, out, Comes::kTheFarWay)});
  }
  return out;
}

/// What lies behind pieces that turn the machine by more than a line is followed, as long as it could drive
/// the line from there.
std::vector<WayEnd> LandSides::behind_bends(const WayEnd& all) const {
  std::vector<WayEnd> out;
  double longest_m = all.follows_m;
  for (WayEnd last = all; !last.to_far_end;) {
    const std::vector<LinePiece> rest =
        pieces_behind(*last.course, last.sense, last.behind_m + last.follows_m);
    if (rest.size() < 2 || !can_drive(rest.front(), costs_.radius_m)) break;
    const double bend_m = rest.front().length_m;
    if (last.follows_m > 0 && kinked_at(last, last.follows_m)) break;
    if (kinked_at(last, last.follows_m + bend_m)) break;
    last = way_end(*all.course, all.from_m, all.sense, 0, Followed::kAll,
                   last.behind_m + last.follows_m + bend_m);
    if (last.follows_m <= longest_m) continue;
    longest_m = last.follows_m;
    out.push_back(last);
  }
  return out;
}

LineEnd LandSides::end_of_line(const WorkedCourse& course, double from_m, double sense,
                               double straight_on_m) const {
  LineEnd out{way_end(course, from_m, sense, straight_on_m, Followed::kAll)};
  if (out.all.turns > kTurnsByRounding)
    out.straight = way_end(course, from_m, sense, straight_on_m, Followed::kStraight);
  out.behind = behind_bends(out.all);
  if (land_)
    out.line = steps_along(pieces_from(course, sense), [&](double at_m) { return out.all.backed(at_m); });
  return out;
}

std::vector<LineStep> LandSides::round(const WorkedCourse& pass) const {
  if (!land_) return {};
  std::vector<LinePiece> pieces;
  for (const PathSegment& segment : pass.line().path())
    pieces.push_back({length(segment), segment.straight() ? 0 : segment.curvature});
  return steps_along(pieces, [&](double at_m) { return pose_of(pass.line().place(at_m)); });
}

/// To back into the pass is to back along it, from another of its places: so it backs along the line.
double LandSides::with_stop_s(const LineEnd& end, const std::vector<LineStep>& pass,
                              const std::function<double(const Pose&)>& on_s) const {
  if (!land_ || may_be_on(pass, places_from(end.all.at, -end.all.sense))) return 0;
  return least_backed_first_s(costs_, end.all, on_s);
}

LineEnd LandSides::leaving(const WorkedCourse& course) const {
  return end_of_line(course, course.length_m() + course.ahead_m(), -1, costs_.turning.lift_m);
}

LineEnd LandSides::entering(const WorkedCourse& course) const {
  return end_of_line(course, course.ahead_m(), 1, costs_.turning.lower_m);
}

LandSides::InBand LandSides::in_band(const WayEnd& from, const WayEnd& to) const {
  const double begins = dot(from.off, band_), ends = -dot(to.off, band_);
  const double slant = std::abs(cross(from.off, band_)) + from.turns;
  const double slant_to = std::abs(cross(to.off, band_)) + to.turns;
  if (slant >= 1 || slant_to >= 1) return InBand::kFree;
  const double cosines = std::sqrt(1 - slant * slant) + std::sqrt(1 - slant_to * slant_to);
  const double takes_m = cosines * (costs_.radius_m + half_m_) - (slant + slant_to) * reach_m_;
  if (band_m_ >= takes_m - kRoomFoundTo_m) return InBand::kFree;
  return (begins > 0) == (ends > 0) ? InBand::kOnward : InBand::kNever;
}

/// What room is left to a machine that moves on from `at` towards the side, backwards if it `works` away from
/// it (+1), forwards if towards it (-1). It has turned to an angle φ only when it is r cos φ − r cos φ₀
/// nearer, and a corner of the outline, half of it aside, has to be on the land then.
LandSides::MovesOn LandSides::moves_on(const HullSide& side, const Pose& at, double works) const {
  const MovesOn anyhow{0, std::numeric_limits<double>::infinity()};
  const double sine = works * dot(at.heading.unit(), side.inwards);
  if (sine <= kSideways) return anyhow;
  const double corner_m = works > 0 ? rear_m_ : front_m_, begins = std::asin(std::min(1.0, sine));
  const double room_m = dot(at.at - side.on, side.inwards) + kRoomFoundTo_m;
  const auto corner_nearer_m = [&](double angle) {
    return half_m_ * std::cos(angle) + corner_m * std::sin(angle);
  };
  const auto left_m = [&](double angle) {
    return room_m - costs_.radius_m * (std::cos(angle) - std::cos(begins)) - corner_nearer_m(angle);
  };
  // Least room is left where corner and turn together come nearest.
  double flatter = std::clamp(std::atan2(corner_m, costs_.radius_m + half_m_), 0.0, begins), steeper = begins;
  if (left_m(flatter) >= 0) return anyhow;
  if (left_m(steeper) >= 0)
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (flatter + steeper);
      (left_m(middle) >= 0 ? steeper : flatter) = middle;
    }
  const double nearer_m = room_m - std::min(corner_nearer_m(steeper), corner_m);
  return {steeper, std::max(0.0, nearer_m) * std::cos(steeper) / std::sin(steeper)};
}

/// All along a line and on, one stop, and to the other end of the way; or the other way round.
bool LandSides::reached_by_one_stop(const WayEnd& all_along, const WayEnd& other) const {
  if (!all_along.to_far_end) return true;
  const Pose far_end = all_along.backed(all_along.follows_m);
  const double works = all_along.sense < 0 ? 1 : -1;
  return std::ranges::all_of(sides_, [&](const HullSide& side) {
    const MovesOn moves = moves_on(side, far_end, works);
    if (moves.flattest == 0) return true;
    const Point along{-side.inwards.y, side.inwards.x};
    const double apart_m = std::abs(dot(other.at.at - far_end.at, along));
    if (apart_m > moves.sideways_m + moves_on(side, other.at, works).sideways_m) return false;
    return std::ranges::none_of(other.sides, [&](const SideAhead& ahead) {
      // Heading away from the one side at least so steeply it heads for the other.
      return dot(ahead.inwards, side.inwards) < -std::cos(moves.flattest);
    });
  });
}

const DrivenPlaces& LandSides::places_from(const Pose& at, double sense) const {
  constexpr double kSamePose = 1e-9;
  const auto known = std::ranges::find_if(driven_, [&](const Driven& driven) {
    return driven.sense == sense && distance(driven.from.at, at.at) < kSamePose &&
           distance(driven.from.heading.unit(), at.heading.unit()) < kSamePose;
  });
  if (known != driven_.end()) return known->places;
  driven_.push_back({at, sense, land_->driven_from(at, sense)});
  return driven_.back().places;
}

/// The machine gets from the end of the one line to where it begins to back into the other, or from where it
/// has backed to on the one to the beginning of the other; not to back at all is to back by nothing.
LandSides::SingleStop LandSides::single_stop(const LineEnd& from, const LineEnd& to) const {
  if (!land_ || from.line.empty() || to.line.empty()) return {};
  const DrivenPlaces &leaves = places_from(from.all.at, 1), &enters = places_from(to.all.at, -1);
  SingleStop out{may_be_on(from.line, enters), may_be_common(places_from(from.line.back().to, -1), enters),
                 may_be_on(to.line, leaves), may_be_common(places_from(to.line.back().to, 1), leaves)};
  const auto leads_forward = [](const Pose& at, const DrivenPlaces& places) {
    return may_be_on({{at, at}}, places);
  };
  const bool once = out.out || out.in || out.out_and_on || out.in_and_on;
  const bool forward = leads_forward(from.all.at, enters) && leads_forward(to.all.at, leaves);
  out.stops = forward ? 0 : once ? 1 : 2;
  return out;
}

/// Ways that back farther than a line is followed: from there any way, with any changes of gear.
double LandSides::farther_s(const WayEnd& from, const WayEnd& to, const SingleStop& may) const {
  const double fastest_mps = std::max(costs_.turning.turning_speed_mps, costs_.turning.reverse_speed_mps);
  const auto beyond_s = [&](const WayEnd& end, const WayEnd& other) {
    const bool along = (&end == &from ? may.out : may.in) && !end.to_far_end;
    const bool on = (&end == &from ? may.out_and_on : may.in_and_on) && reached_by_one_stop(end, other);
    return std::max(may.stops, along || on ? 1 : 2) * costs_.stop_s +
           (end.behind_m + end.follows_m) / costs_.turning.reverse_speed_mps +
           least_with_reversing_m(end.backed(end.follows_m), other.at, costs_.radius_m) / fastest_mps -
           other.behind_m / costs_.turning.turning_speed_mps;
  };
  return std::min(beyond_s(from, to), beyond_s(to, from));
}

double LandSides::along_lines_s(const WayEnd& from, const WayEnd& to, const SingleStop& may,
                                double known_s) const {
  const InBand band = in_band(from, to);
  if (band == InBand::kNever) return kNever_s;
  const Asked of_from = asked(from, to, costs_.radius_m), of_to = asked(to, from, costs_.radius_m);
  double back_m = 0;
  if (band == InBand::kOnward) {
    const double sense = dot(from.off, band_) > 0 ? 1 : -1;
    back_m = std::max(0.0, sense * dot(from.at.at - to.at.at, band_));
  }
  // A way that cannot do with a stop at one line backs along the other.
  const std::optional<double> out_m = may.in ? std::nullopt : std::optional(0.0),
                              in_m = may.out ? std::nullopt : std::optional(0.0);
  std::vector<BackedAsAsked> ways{
      {std::max(of_from.back_m, out_m), std::max(of_to.back_m, in_m), back_m, 0, 0, may.stops}};
  const Instead &one = of_from.instead, &other = of_to.instead;
  const double together_m = std::min(one.together_m, other.together_m);
  if (together_m < kNever_s)
    ways.push_back({out_m, in_m, std::max(back_m, together_m), std::min(one.here_m, other.there_m),
                    std::min(one.there_m, other.here_m), may.stops});
  return least_backed_s(costs_, from, to, ways, known_s);
}

double LandSides::way_s(const WayEnd& from, const WayEnd& to, const SingleStop& may, double known_s,
                        double enough_s) const {
  const bool always = may.stops == 0 && may.out_and_on && may.in_and_on;
  const bool bounded = !always || in_band(from, to) != InBand::kFree ||
                       asked(from, to, costs_.radius_m).back_m || asked(to, from, costs_.radius_m).back_m ||
                       !turned_round(from, to).empty();
  if (!bounded) return known_s;
  const double beyond_s = farther_s(from, to, may);
  if (beyond_s <= known_s) return known_s;
  return std::max(known_s, std::min(beyond_s, along_lines_s(from, to, may, std::min(beyond_s, enough_s))));
}

double LandSides::both_s(const LineEnd& from, const LineEnd& to, const SingleStop& may, double known_s,
                         double enough_s) const {
  const double all_s = way_s(from.all, to.all, may, known_s, enough_s);
  if (all_s >= enough_s || (!from.straight && !to.straight)) return all_s;
  return way_s(from.straight.value_or(from.all), to.straight.value_or(to.all), may, all_s, enough_s);
}

/// From behind the bends of either line.
double LandSides::behind_bends_s(const LineEnd& from, const LineEnd& to, int stops, double known_s,
                                 double enough_s) const {
  const auto ends = [](const LineEnd& line) {
    return line.behind.empty() ? std::vector<WayEnd>{line.all} : line.behind;
  };
  double out_s = known_s;
  SingleStop may;
  may.stops = stops;
  if (from.behind.empty() && to.behind.empty()) return out_s;
  for (const WayEnd& leaves : ends(from))
    for (const WayEnd& enters : ends(to))
      if (out_s < enough_s) out_s = way_s(leaves, enters, may, out_s, enough_s);
  return out_s;
}

double LandSides::least_s(const LineEnd& from, const LineEnd& to, double known_s, double enough_s) const {
  const double anyhow_s = behind_bends_s(from, to, 0, both_s(from, to, {}, known_s, enough_s), enough_s);
  if (anyhow_s >= enough_s || !land_) return anyhow_s;
  const SingleStop may = single_stop(from, to);
  return behind_bends_s(from, to, may.stops, both_s(from, to, may, anyhow_s, enough_s), enough_s);
}

}  // namespace tramline::check
