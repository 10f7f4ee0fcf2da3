#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/check/turning/shortest_ways.h"

namespace tramline::check {
namespace {

/// Prices are times of ways. Sums of far larger ones, which cancel, prove anything by rounding alone.
constexpr double kLargestPrice_s = 1e7;
constexpr double kNever_s = std::numeric_limits<double>::infinity();

Pose pose_of(const LinePlace& place) { return {place.at, Heading::from_to({0, 0}, place.ahead)}; }
Pose moved_on(const Pose& pose, double by_m) { return {pose.at + by_m * pose.heading.unit(), pose.heading}; }

/// An end of a line, or a gate.
struct Node {
  Pose left;     ///< the axle, where the work ends there
  Pose entered;  ///< where the work begins there
  bool gate = false;
};

/// What a route joins: lines, whose ends are two nodes, and gates, which are one.
struct Member {
  std::size_t first = 0;  ///< of its nodes
  std::size_t count = 2;
};

void add_line(const WorkedCourse& first, const WorkedCourse& first_back, const WorkedCourse& last,
              const WorkedCourse& last_back, std::vector<Node>& out) {
  out.push_back({pose_of(first_back.axle(first_back.length_m())), pose_of(first.axle(0))});
  out.push_back({pose_of(last.axle(last.length_m())), pose_of(last_back.axle(0))});
}

class Bound {
 public:
  explicit Bound(const Plan& plan)
      : plan_(plan),
        turning_(plan.machine.turning),
        prices_s_(plan.route.proof.node_prices_s),
        radius_m_(std::max(plan.machine.radius_m, kLeastRadius_m)),
        reverses_(turning_.implement != Coupling::kTowed || !(turning_.drawbar_m > 0)),
        fastest_mps_(reverses_ ? std::max(turning_.turning_speed_mps, turning_.reverse_speed_mps)
                               : turning_.turning_speed_mps) {
    add_pieces();
    add_passes();
    lines_ = nodes_.size() / 2;
    const std::vector<RouteLeg>& legs = plan.route.legs;
    if (plan.settings.route.start) add_gate(legs.front().path.front().start.at);
    if (plan.settings.route.end) add_gate(last_place(legs.back().path).at);
  }

  /// One for each node, none so large that times are lost in it. Written so that NaN is none.
  bool has_prices() const {
    return prices_s_.size() == nodes_.size() && std::all_of(prices_s_.begin(), prices_s_.end(), [](double s) {
             return std::abs(s) <= kLargestPrice_s;
           });
  }
  /// Of the nodes where there are lines: a route without any has none.
  bool needs_prices() const { return lines_ > 0; }

  double seconds() const { return fixed_s() + (needs_prices() ? std::max(0.0, connections_s()) : 0); }

 private:
  void add_pieces() {
    const std::size_t count = plan_.pieces.size();
    for (std::size_t first = 0, next = 0; first < count; first = next) {
      for (next = first + 1; next < count && plan_.pieces[next].after_crossing;) ++next;
      const auto back = [&](std::size_t i) {
        return WorkedCourse(reversed(centre_line(plan_.pieces[i])), PathEnds::kApart, plan_.machine);
      };
      add_line(course_of_piece(plan_, first), back(first), course_of_piece(plan_, next - 1), back(next - 1),
               nodes_);
      for (std::size_t i = first; i + 1 < next; ++i) {
        const WorkedCourse before = course_of_piece(plan_, i);
        crossings_m_ += distance(before.axle(before.length_m()).at, course_of_piece(plan_, i + 1).axle(0).at);
      }
      members_.push_back({nodes_.size() - 2, 2});
    }
  }

  void add_passes() {
    for (std::size_t i = 0; i < plan_.headland.passes.size(); ++i) {
      if (is_closed(plan_.headland.passes[i])) continue;
      const WorkedCourse pass = course_of_pass(plan_, i, PassSense::kAlong),
                         back = course_of_pass(plan_, i, PassSense::kAgainst);
      add_line(pass, back, pass, back, nodes_);
      members_.push_back({nodes_.size() - 2, 2});
    }
  }

  void add_gate(Point at) {
    const Pose pose{at, Heading::clockwise_from_north(Angle::degrees(0))};
    members_.push_back({nodes_.size(), 1});
    nodes_.push_back({pose, pose, true});
  }

  /// What every route drives: pieces, passes, and crossings of passable obstacles on both.
  double fixed_s() const {
    double out = crossings_m_ / turning_.turning_speed_mps;
    for (const TrackPiece& piece : plan_.pieces) out += length(piece) / turning_.working_speed_mps;
    for (const RouteLeg& leg : plan_.route.legs)
      if (leg.pass) out += length(leg) / (leg.work ? turning_.working_speed_mps : turning_.turning_speed_mps);
    return out;
  }

  /// The least time from leaving by one pose to entering by another, s.
  double least_s(const Pose& left, const Pose& entered) const {
    const double forward_m =
        turning_.lift_m + turning_.lower_m +
        least_forward_m(moved_on(left, turning_.lift_m), moved_on(entered, -turning_.lower_m), radius_m_);
    const double forward_s = forward_m / turning_.turning_speed_mps;
    const double changes_s = 2 * turning_.gear_change_s;
    if (!reverses_ || changes_s + distance(left.at, entered.at) / fastest_mps_ >= forward_s) return forward_s;
    return std::min(forward_s, changes_s + least_with_reversing_m(left, entered, radius_m_) / fastest_mps_);
  }

  double least_s(const Node& a, const Node& b) const {
    if (a.gate || b.gate) return straight_s(a, b);
    return std::min(least_s(a.left, b.entered), least_s(b.left, a.entered));
  }

  /// No way is quicker than the straight one.
  double straight_s(const Node& a, const Node& b) const {
    return std::min(distance(a.left.at, b.entered.at), distance(b.left.at, a.entered.at)) / fastest_mps_;
  }

  /// The cheapest join under prices; `known_s` where none is cheaper.
  double cheapest_s(const Member& one, const Member& other, double known_s) const {
    if (nodes_[one.first].gate && nodes_[other.first].gate) return known_s;
    for (std::size_t a = one.first; a < one.first + one.count; ++a)
      for (std::size_t b = other.first; b < other.first + other.count; ++b) {
        const double prices_s = prices_s_[a] + prices_s_[b];
        if (straight_s(nodes_[a], nodes_[b]) + prices_s < known_s)
          known_s = std::min(known_s, least_s(nodes_[a], nodes_[b]) + prices_s);
      }
    return known_s;
  }

  /// The least spanning tree of the members (Prim 1957).
  double tree_s() const {
    std::vector<double> join_s(members_.size(), kNever_s);
    std::vector<bool> joined(members_.size(), false);
    double sum_s = 0;
    std::size_t latest = 0;
    for (std::size_t count = 1; count < members_.size(); ++count) {
      joined[latest] = true;
      std::size_t next = members_.size();
      for (std::size_t i = 0; i < members_.size(); ++i) {
        if (joined[i]) continue;
        join_s[i] = cheapest_s(members_[latest], members_[i], join_s[i]);
        if (next == members_.size() || join_s[i] < join_s[next]) next = i;
      }
      sum_s += join_s[next];
      latest = next;
    }
    return sum_s;
  }

  /// A route is a spanning tree in which every node has one connection, but for an end without gate.
  double connections_s() const {
    double out = tree_s();
    for (const double price_s : prices_s_) out -= price_s;
    std::vector<double> of_lines(prices_s_.begin(),
                                 prices_s_.begin() + static_cast<std::ptrdiff_t>(2 * lines_));
    std::sort(of_lines.begin(), of_lines.end());
    const std::size_t gates = nodes_.size() - 2 * lines_;
    for (std::size_t i = 0; i + gates < 2; ++i) out += of_lines[i];
    return out;
  }

  const Plan& plan_;
  const Turning& turning_;
  const std::vector<double>& prices_s_;
  double radius_m_;
  bool reverses_;
  double fastest_mps_;
  std::vector<Node> nodes_;
  std::vector<Member> members_;
  std::size_t lines_ = 0;
  double crossings_m_ = 0;
};

}  // namespace

void check_route_bound(const Case& c, Violations& out) {
  const Route& route = c.plan.route;
  if (!route.planned()) return;
  const Point at = route.legs.front().path.front().start.at;
  const double stated_s = route.proof.bound_s;
  double time_s = 0;
  for (const RouteLeg& leg : route.legs) time_s += leg.time_s;
  const double rounding_s = kTimeShare * std::max(1.0, time_s);
  if (!(stated_s <= time_s + rounding_s))
    out.push_back({Rule::kRouteBound,
                   fmt::format("the route takes {:.3f} s, less than its bound of {:.3f} s", time_s, stated_s),
                   at, stated_s - time_s});
  const Bound bound(c.plan);
  if (bound.needs_prices() && !bound.has_prices()) {
    out.push_back(
        {Rule::kRouteBound,
         fmt::format("the bound of the route has {} prices, not a sound one for each end and each gate",
                     route.proof.node_prices_s.size()),
         at, static_cast<double>(route.proof.node_prices_s.size())});
    return;
  }
  const double found_s = bound.seconds();
  if (!(stated_s <= found_s + rounding_s))
    out.push_back({Rule::kRouteBound,
                   fmt::format("the prices prove that no route takes less than {:.3f} s, not {:.3f} s",
                               found_s, stated_s),
                   at, stated_s - found_s});
}

}  // namespace tramline::check
