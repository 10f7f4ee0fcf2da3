#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tramline/check/rules/route/route_nodes.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/model/rate_values.h"

namespace tramline::check {
namespace {

/// Prices are times of ways. Sums of far larger ones, which cancel, prove anything by rounding alone.
constexpr double kLargestPrice_s = 1e7;

class Bound {
 public:
  explicit Bound(const Plan& plan)
      : plan_(plan),
        prices_s_(plan.route.proof.node_prices_s),
        route_(nodes_of_route(plan)),
        ways_(plan.machine, plan.route.proof.stop_s, route_.sides) {}

  /// One for each node, none so large that times are lost in it. Written so that NaN is none.
  bool has_prices() const {
    return prices_s_.size() == route_.nodes.size() &&
           std::all_of(prices_s_.begin(), prices_s_.end(),
                       [](double s) { return std::abs(s) <= kLargestPrice_s; });
  }
  /// A route that joins nothing but gates has none.
  bool needs_prices() const {
    return std::any_of(route_.nodes.begin(), route_.nodes.end(),
                       [](const RouteNode& node) { return node.kind != NodeKind::kGate; });
  }

  double seconds() const { return fixed_s() + (needs_prices() ? std::max(0.0, connections_s()) : 0); }

 private:
  const RouteNode& first_node(const RouteMember& member) const { return route_.nodes[member.first]; }

  /// What every route drives: pieces, passes, and crossings of passable obstacles on both.
  double fixed_s() const {
    const Turning& turning = plan_.machine.turning;
    double out = route_.crossings_m / turning.turning_speed_mps;
    for (const TrackPiece& piece : plan_.pieces) out += length(piece) / turning.working_speed_mps;
    for (const RouteLeg& leg : plan_.route.legs)
      if (leg.pass) out += length(leg) / (leg.work ? turning.working_speed_mps : turning.turning_speed_mps);
    return out;
  }

  /// The cheapest join under prices; `known_s` where none is cheaper.
  double cheapest_s(const RouteMember& one, const RouteMember& other, double known_s) const {
    if (first_node(one).kind == NodeKind::kGate && first_node(other).kind == NodeKind::kGate) return known_s;
    for (std::size_t a = one.first; a < one.first + one.count; ++a)
      for (std::size_t b = other.first; b < other.first + other.count; ++b) {
        const double prices_s = prices_s_[a] + prices_s_[b];
        const RouteNode &from = route_.nodes[a], &to = route_.nodes[b];
        if (ways_.straight_s(from, to) + prices_s < known_s)
          known_s = std::min(known_s, ways_.between(from, to, known_s - prices_s) + prices_s);
      }
    return known_s;
  }

  /// The least spanning tree of things of which two are joined at `join_s(a, b, known_s)` (Prim 1957).
  template <class Join>
  static double tree_s(std::size_t count, const Join& join_s) {
    std::vector<double> least_s(count, kNever_s);
    std::vector<bool> joined(count, false);
    double sum_s = 0;
    std::size_t latest = 0;
    for (std::size_t done = 1; done < count; ++done) {
      joined[latest] = true;
      std::size_t next = count;
      for (std::size_t i = 0; i < count; ++i) {
        if (joined[i]) continue;
        least_s[i] = join_s(latest, i, least_s[i]);
        if (next == count || least_s[i] < least_s[next]) next = i;
      }
      sum_s += least_s[next];
      latest = next;
    }
    return sum_s;
  }

  /// The route makes one join from each phase to the next: a tree over each, and one over all of them.
  double trees_s() const {
    std::map<std::size_t, std::vector<RouteMember>> by_phase;
    for (const RouteMember& member : route_.members) by_phase[first_node(member).phase].push_back(member);
    std::vector<std::vector<RouteMember>> phases;
    for (auto& [number, members] : by_phase) phases.push_back(std::move(members));
    double out = 0;
    for (const std::vector<RouteMember>& phase : phases)
      out += tree_s(phase.size(), [&](std::size_t a, std::size_t b, double known_s) {
        return cheapest_s(phase[a], phase[b], known_s);
      });
    return out + tree_s(phases.size(), [&](std::size_t a, std::size_t b, double known_s) {
             for (const RouteMember& one : phases[a])
               for (const RouteMember& other : phases[b]) known_s = cheapest_s(one, other, known_s);
             return known_s;
           });
  }

  /// A route is a spanning tree that joins each end and each gate once and each closed pass twice, but once
  /// less where it has an end without gate.
  double connections_s() const {
    double out = trees_s();
    std::vector<double> of_ends;
    for (std::size_t i = 0; i < prices_s_.size(); ++i) {
      const NodeKind kind = route_.nodes[i].kind;
      out -= kind == NodeKind::kClosedPass ? 2 * prices_s_[i] : prices_s_[i];
      if (kind != NodeKind::kGate) of_ends.push_back(prices_s_[i]);
    }
    std::sort(of_ends.begin(), of_ends.end());
    const std::size_t gates = prices_s_.size() - of_ends.size();
    // A closed pass alone is where the route starts and where it ends.
    for (std::size_t i = 0; i + gates < 2; ++i) out += of_ends[std::min(i, of_ends.size() - 1)];
    return out;
  }

  const Plan& plan_;
  const std::vector<double>& prices_s_;
  RouteNodes route_;
  LeastWays ways_;
};

}  // namespace

void check_route_bound(const Case& c, Violations& out) {
  const Route& route = c.plan.route;
  if (!route.planned()) return;
  const Point at = route.legs.front().path.front().start.at;
  const double stated_s = route.proof.bound_s;
  // Written so that NaN is none.
  if (!(route.proof.stop_s >= 0 && route.proof.stop_s <= kLongestStop_s)) {
    out.push_back({Rule::kRouteBound,
                   fmt::format("a stop counts {:.3f} s in the bound of the route, not 0 to {:g} s",
                               route.proof.stop_s, kLongestStop_s),
                   at, route.proof.stop_s});
    return;
  }
  double counts_s = 0;
  for (const RouteLeg& leg : route.legs)
    counts_s += leg.time_s + (leg.kind == LegKind::kBackOut ? route.proof.stop_s : 0);
  const double rounding_s = kTimeShare * std::max(1.0, counts_s);
  if (!(stated_s <= counts_s + rounding_s))
    out.push_back({Rule::kRouteBound,
                   fmt::format("the time of the route and its stops come to {:.3f} s, less than its bound of "
                               "{:.3f} s",
                               counts_s, stated_s),
                   at, stated_s - counts_s});
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
                   fmt::format("the prices prove that no route counts less than {:.3f} s, not {:.3f} s",
                               found_s, stated_s),
                   at, stated_s - found_s});
}

}  // namespace tramline::check
