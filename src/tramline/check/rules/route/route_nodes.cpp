#include "tramline/check/rules/route/route_nodes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/driven_machine.h"
#include "tramline/check/turning/shortest_ways.h"

namespace tramline::check {
namespace {

/// Places of closed passes: so many a metre, up to so many in all.
constexpr double kPlacesAMetre = 2, kMostPlaces = 1000;
constexpr double kWholeMetre_m = 1e-3;
constexpr double kNextPasses_widths = 1.5;

RouteNode line_end(const WorkedCourse& arriving, const WorkedCourse& leaving, std::size_t phase,
                   const std::optional<LandSides>& sides) {
  RouteNode out;
  out.phase = phase;
  if (sides) {
    out.leaving = sides->leaving(arriving);
    out.entering = sides->entering(leaving);
  }
  out.left = {pose_of(arriving.axle(arriving.length_m()))};
  out.entered = {pose_of(leaving.axle(0))};
  return out;
}

/// Tracks and passes by the phases in which a route works them: a phase ends where a track follows a pass or
/// a pass a track, but for passes between tracks that go round obstacles alone. What the route does not work
/// is in the first.
class WorkPhases {
 public:
  explicit WorkPhases(const Plan& plan) {
    const std::vector<const RouteLeg*> works = works_of(plan.route);
    for (std::size_t i = 0; i < works.size(); ++i) {
      const bool changes = i > 0 && works[i]->pass.has_value() != works[i - 1]->pass.has_value();
      if (changes && !is_among_tracks(works, works[i]->pass ? i : i - 1, plan)) ++last_;
      if (works[i]->pass)
        by_pass_[*works[i]->pass] = last_;
      else
        by_piece_[*works[i]->piece] = last_;
    }
  }
  std::size_t last() const { return last_; }
  std::size_t of_piece(std::size_t piece) const { return found(by_piece_, piece); }
  std::size_t of_pass(std::size_t pass) const { return found(by_pass_, pass); }

 private:
  static std::vector<const RouteLeg*> works_of(const Route& route) {
    std::vector<const RouteLeg*> out;
    for (const RouteLeg& leg : route.legs)
      if (leg.piece || leg.pass) out.push_back(&leg);
    return out;
  }

  /// Of passes one after the other, of which this is one.
  static bool is_among_tracks(const std::vector<const RouteLeg*>& works, std::size_t pass, const Plan& plan) {
    const auto along_field = [&](std::size_t i) {
      return plan.headland.passes[*works[i]->pass].around_field;
    };
    std::size_t first = pass, last = pass;
    bool around_field = along_field(pass);
    while (first > 0 && works[first - 1]->pass) around_field = along_field(--first) || around_field;
    while (last + 1 < works.size() && works[last + 1]->pass)
      around_field = along_field(++last) || around_field;
    return !around_field && first > 0 && last + 1 < works.size();
  }

  static std::size_t found(const std::map<std::size_t, std::size_t>& phases, std::size_t of) {
    const auto at = phases.find(of);
    return at == phases.end() ? 0 : at->second;
  }
  std::map<std::size_t, std::size_t> by_piece_, by_pass_;
  std::size_t last_ = 0;
};

class Nodes {
 public:
  explicit Nodes(const Plan& plan) : plan_(plan), phases_(plan) { out_.sides = LandSides::of(plan); }

  RouteNodes run() {
    add_pieces();
    for (std::size_t i = 0; i < plan_.headland.passes.size(); ++i)
      if (!is_closed(plan_.headland.passes[i])) add_open_pass(i);
    std::vector<std::size_t> closed;
    // Along sharp corners nothing drives from one place to the next.
    if (plan_.headland.construction == HeadlandConstruction::kDrivable)
      for (std::size_t i = 0; i < plan_.headland.passes.size(); ++i)
        if (is_closed(plan_.headland.passes[i])) closed.push_back(i);
    const RouteSettings& asked = plan_.settings.route;
    const std::vector<RouteLeg>& legs = plan_.route.legs;
    if (asked.start) add_gate(legs.front().path.front().start.at, 0);
    if (asked.end) add_gate(last_place(legs.back().path).at, phases_.last());
    for (const std::size_t pass : closed) add_closed_pass(pass);
    return std::move(out_);
  }

 private:
  void add_member(std::vector<RouteNode> nodes) {
    out_.members.push_back({out_.nodes.size(), nodes.size()});
    for (RouteNode& node : nodes) out_.nodes.push_back(std::move(node));
  }

  void add_pieces() {
    const std::size_t count = plan_.pieces.size();
    for (std::size_t first = 0, next = 0; first < count; first = next) {
      for (next = first + 1; next < count && plan_.pieces[next].after_crossing;) ++next;
      const auto back = [&](std::size_t i) {
        return WorkedCourse(reversed(centre_line(plan_.pieces[i])), PathEnds::kApart, plan_.machine);
      };
      const std::size_t phase = phases_.of_piece(first);
      add_member({line_end(back(first), course_of_piece(plan_, first), phase, out_.sides),
                  line_end(course_of_piece(plan_, next - 1), back(next - 1), phase, out_.sides)});
      for (std::size_t i = first; i + 1 < next; ++i) {
        const WorkedCourse before = course_of_piece(plan_, i);
        out_.crossings_m +=
            distance(before.axle(before.length_m()).at, course_of_piece(plan_, i + 1).axle(0).at);
      }
    }
  }

  void add_open_pass(std::size_t i) {
    const WorkedCourse pass = course_of_pass(plan_, i, PassSense::kAlong),
                       back = course_of_pass(plan_, i, PassSense::kAgainst);
    const std::size_t phase = phases_.of_pass(i);
    add_member({line_end(back, pass, phase, out_.sides), line_end(pass, back, phase, out_.sides)});
  }

  void add_gate(Point at, std::size_t phase) {
    RouteNode gate;
    gate.kind = NodeKind::kGate;
    gate.phase = phase;
    gate.left = gate.entered = {{at, Heading::clockwise_from_north(Angle::degrees(0))}};
    add_member({gate});
  }

  void add_closed_pass(std::size_t i) {
    RouteNode pass;
    pass.kind = NodeKind::kClosedPass;
    pass.phase = phases_.of_pass(i);
    for (const PassSense sense : {PassSense::kAlong, PassSense::kAgainst}) {
      const WorkedCourse course = course_of_pass(plan_, i, sense);
      const double places =
          std::clamp(std::ceil(kPlacesAMetre * (course.length_m() - kWholeMetre_m)), 1.0, kMostPlaces);
      pass.step_m = course.length_m() / places;
      for (double place = 0; place < places; ++place)
        pass.left.push_back(pose_of(course.axle(place / places * course.length_m())));
      if (!out_.sides) continue;
      const std::vector<LineStep> line = out_.sides->round(course);
      pass.line.insert(pass.line.end(), line.begin(), line.end());
    }
    pass.entered = pass.left;
    add_member({pass});
  }

  const Plan& plan_;
  WorkPhases phases_;
  RouteNodes out_;
};

/// Between the places of two nodes. Of closed passes those of one sense count.
double least_distance_m(const RouteNode& a, const RouteNode& b) {
  const auto places = [](const std::vector<Pose>& poses, const RouteNode& of) {
    return of.kind == NodeKind::kClosedPass ? poses.size() / 2 : poses.size();
  };
  double out_m = kNever_s;
  for (std::size_t i = 0; i < places(a.left, a); ++i)
    for (std::size_t j = 0; j < places(b.entered, b); ++j)
      out_m = std::min(out_m, distance(a.left[i].at, b.entered[j].at));
  return out_m;
}

}  // namespace

RouteNodes nodes_of_route(const Plan& plan) {
  assert(plan.route.planned() && !plan.route.legs.front().path.empty());
  return Nodes(plan).run();
}

LeastWays::LeastWays(const Machine& machine, double stop_s, std::optional<LandSides> sides)
    : turning_(machine.turning),
      width_m_(machine.width_m),
      radius_m_(std::max(machine.radius_m, kLeastRadius_m)),
      reverses_(!tows(turning_)),
      fastest_mps_(reverses_ ? std::max(turning_.turning_speed_mps, turning_.reverse_speed_mps)
                             : turning_.turning_speed_mps),
      reversing_s_(2 * turning_.gear_change_s + (turning_.reverse ? 0 : stop_s)),
      sides_(std::move(sides)) {}

/// From leaving by one pose to entering by another; `known_s` or more where it is no less.
double LeastWays::least_s(const Pose& left, double lift_m, const Pose& entered, double lower_m,
                          double known_s) const {
  const double straight_s = distance(left.at, entered.at) / fastest_mps_;
  if (straight_s >= known_s) return straight_s;
  const double forward_m =
      lift_m + lower_m + least_forward_m(moved_on(left, lift_m), moved_on(entered, -lower_m), radius_m_);
  const double forward_s = forward_m / turning_.turning_speed_mps;
  if (!reverses_ || reversing_s_ + straight_s >= std::min(forward_s, known_s)) return forward_s;
  return std::min(forward_s, reversing_s_ + least_with_reversing_m(left, entered, radius_m_) / fastest_mps_);
}

double LeastWays::least_of_places_s(const RouteNode& from, double lift_m, const RouteNode& to,
                                    double lower_m) const {
  double out_s = kNever_s;
  for (const Pose& left : from.left)
    for (const Pose& entered : to.entered)
      out_s = std::min(out_s, least_s(left, lift_m, entered, lower_m, out_s));
  return out_s;
}

/// At a closed pass the implement is lifted and lowered anywhere along it.
double LeastWays::one_way_s(const RouteNode& from, const RouteNode& to, double enough_s) const {
  const double lift_m = from.kind == NodeKind::kClosedPass ? 0 : turning_.lift_m;
  const double lower_m = to.kind == NodeKind::kClosedPass ? 0 : turning_.lower_m;
  const double out_s = least_of_places_s(from, lift_m, to, lower_m);
  if (!from.leaving || !to.entering) return out_s;
  return sides_->least_s(*from.leaving, *to.entering, out_s, enough_s);
}

/// What a way from a line to a closed pass takes, or to a line from there, where it has to stop. Having
/// backed it need not lift the implement, nor lower it before it does.
double LeastWays::with_stop_s(const RouteNode& from, const RouteNode& to) const {
  if (!sides_) return 0;
  const auto standing_at = [](const Pose& pose) {
    RouteNode out;
    out.left = out.entered = {pose};
    return out;
  };
  if (from.leaving && to.kind == NodeKind::kClosedPass)
    return sides_->with_stop_s(*from.leaving, to.line, [&](const Pose& pose) {
      return std::max(0.0, least_of_places_s(standing_at(pose), 0, to, 0) - steps_s(from, to));
    });
  if (from.kind == NodeKind::kClosedPass && to.entering)
    return sides_->with_stop_s(*to.entering, from.line, [&](const Pose& pose) {
      return std::max(0.0, least_of_places_s(from, 0, standing_at(pose), 0) - steps_s(from, to));
    });
  return 0;
}

double LeastWays::steps_s(const RouteNode& a, const RouteNode& b) const {
  return (a.step_m + b.step_m) / turning_.turning_speed_mps;
}

double LeastWays::between(const RouteNode& a, const RouteNode& b, double enough_s) const {
  const double straight = straight_s(a, b);
  if (a.kind == NodeKind::kGate || b.kind == NodeKind::kGate) return straight;
  const bool both_closed = a.kind == NodeKind::kClosedPass && b.kind == NodeKind::kClosedPass;
  // Places are as far from the nearest ones as passes are from one another but for steps along both.
  const double next_m = kNextPasses_widths * width_m_ + 2 * (a.step_m + b.step_m);
  if (both_closed && straight * fastest_mps_ > next_m) return straight;
  const double step_s = steps_s(a, b);
  const auto least_s = [&](const RouteNode& from, const RouteNode& to, double up_to_s) {
    return std::max({one_way_s(from, to, up_to_s + step_s) - step_s, with_stop_s(from, to), straight});
  };
  const double there_s = least_s(a, b, enough_s);
  return std::min(there_s, least_s(b, a, std::min(there_s, enough_s)));
}

double LeastWays::straight_s(const RouteNode& a, const RouteNode& b) const {
  const double least_m = std::min(least_distance_m(a, b), least_distance_m(b, a));
  return std::max(0.0, least_m - a.step_m - b.step_m) / fastest_mps_;
}

}  // namespace tramline::check
