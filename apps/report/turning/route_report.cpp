#include "report/turning/route_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/report_parts.h"
#include "tramline/model/plain_zero.h"
#include "tramline/model/rate_values.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

ordered_json leg_json(const RouteLeg& leg, std::size_t seq) {
  ordered_json out{{"seq", seq},       {"kind", name(leg.kind)},  {"gear", name(leg.gear)},
                   {"work", leg.work}, {"length_m", length(leg)}, {"time_s", leg.time_s}};
  if (leg.piece) out["piece"] = *leg.piece + 1;
  if (leg.pass) out["pass"] = *leg.pass + 1;
  if (leg.missing_m > 0) out["missing_m"] = leg.missing_m;
  return out;
}

/// By how much its time, and the price of its stops to back out, are above those of the best of all routes at
/// the most, of that one's. A bound of 0 says nothing.
std::string proof_text(const Route& route, std::size_t back_outs) {
  const double bound_s = route.proof.bound_s, stop_s = route.proof.stop_s;
  if (bound_s <= 0) return "";
  const double above_s = std::max(0.0, priced_time_s(route) - bound_s);
  const std::string counted =
      stop_s > 0 && back_outs > 0 ? fmt::format(", each stop to back out counted as {:.0f} s", stop_s) : "";
  return fmt::format("; at most {:.1f} % {}{}", plain_zero(100 * above_s / bound_s),
                     stop_s > 0 ? "above the best" : "longer than the quickest", counted);
}

std::string speeds_text(const Turning& turning, const RouteSums& sums) {
  std::string out = fmt::format("{:g} m/s, {:g} m/s with the work off", turning.working_speed_mps,
                                turning.turning_speed_mps);
  if (sums.reverse_m > 0) out += fmt::format(", {:g} m/s in reverse", turning.reverse_speed_mps);
  return out;
}

std::string first_row(const Plan& plan, const RouteSums& sums) {
  const double share = sums.length_m > 0 ? 100 * sums.not_working_m() / sums.length_m : 0;
  return fmt::format("route        {:.3f} km ({}), {:.1f} % of it not working{}\n", sums.length_m / 1e3,
                     speeds_text(plan.machine.turning, sums), share, proof_text(plan.route, sums.back_outs));
}

/// Which legs leave the land, and where they begin, in local metres.
std::string room_row(const Plan& plan) {
  const Route& route = plan.route;
  const std::size_t without_room = legs_without_room(route, plan.machine);
  if (without_room == 0) return "";
  constexpr std::size_t kShown = 3;
  double most_m = 0;
  std::vector<std::string> where;
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    const RouteLeg& leg = route.legs[i];
    if (!lacks_room(leg, plan.machine)) continue;
    most_m = std::max(most_m, leg.missing_m);
    if (where.size() == kShown) continue;
    std::string text = fmt::format("leg {}", i + 1);
    if (!leg.path.empty()) {
      const Point at = leg.path.front().start.at;
      text += fmt::format(" from ({:.1f}, {:.1f})", plain_zero(at.x), plain_zero(at.y));
    }
    where.push_back(std::move(text));
  }
  const std::string more = without_room > kShown ? fmt::format(" and {} more", without_room - kShown) : "";
  return fmt::format("no room      for {} {}, which {} the land by up to {:.1f} m: {}{}\n", without_room,
                     without_room == 1 ? "leg" : "legs", without_room == 1 ? "leaves" : "leave", most_m,
                     fmt::join(where, ", "), more);
}

}  // namespace

ordered_json rates_json(const Machine& machine) {
  const Rates rates = rates_of(machine);
  ordered_json out{{kOperationKey, name(rates.operation)}};
  for (const RateNumber& number : kRateNumbers) out[number.key] = rates.*number.value;
  return out;
}

ordered_json whole_cost_json(const Plan& plan) {
  assert(plan.route.planned());
  const WholeCost cost = whole_cost(plan);
  constexpr double kHour_s = 3600;
  const double time_s = cost.time_s();
  return {{"euros", cost.euros()},
          {"hours", time_s / kHour_s},
          {"litres", cost.fuel_l},
          {"working_h", cost.working_s / kHour_s},
          {"headland_h", cost.headland_s / kHour_s},
          {"turning_h", cost.turning_s / kHour_s},
          {"transit_h", cost.transit_s / kHour_s},
          {"not_working_share", time_s > 0 ? cost.not_working_s() / time_s : 0},
          {"field_efficiency", cost.field_efficiency},
          {"euros_hours", cost.hours},
          {"euros_fuel", cost.fuel},
          {"euros_overlap", cost.overlap},
          {"euros_missed", cost.missed},
          {"euros_stops", cost.stops},
          {"euros_driven_over", cost.driven_over},
          {"euros_without_room", cost.without_room},
          {"rates", rates_json(plan.machine)}};
}

ordered_json compared_routes_json(const std::vector<RouteAlternative>& routes) {
  ordered_json out = ordered_json::array();
  for (const RouteAlternative& route : routes) {
    ordered_json directions = ordered_json::array();
    for (const Direction direction : route.directions) directions.push_back(direction.degrees());
    out.push_back({{"kind", name(route.kind)},
                   {"directions_deg", std::move(directions)},
                   {"headlands", route.headlands},
                   {"all_round", route.all_round},
                   {"hours", route.cost.time_s() / 3600},
                   {"euros", route.cost.euros()},
                   {"without_room", route.without_room},
                   {"dropped", route.dropped}});
  }
  return out;
}

std::string compared_routes_rows(const std::vector<RouteAlternative>& routes) {
  if (routes.empty()) return "";
  constexpr std::size_t kShown = 3;
  std::string out = "compared     by the cost of their whole routes; the first is planned\n";
  for (const RouteAlternative& route : routes) {
    const std::string passes =
        route.headlands == 0
            ? "no headland"
            : fmt::format("{} {} {}", route.headlands, route.headlands == 1 ? "pass" : "passes",
                          route.all_round ? "all round" : "where tracks end");
    const std::string why =
        route.kind == Alternative::kNoHeadland ? "" : fmt::format(", {}", name(route.kind));
    const std::string dropped = route.dropped == 0 ? ""
                                                   : fmt::format(" but {} {}", route.dropped,
                                                                 route.dropped == 1 ? "piece" : "pieces");
    const std::string tracks =
        route.directions.empty() ? "no tracks" : "tracks at " + directions_text(route.directions, kShown);
    out += fmt::format("             {:.2f} €, {:.2f} h: {}{}, {}{}{}\n", route.cost.euros(),
                       route.cost.time_s() / 3600, tracks, dropped, passes, why,
                       route.without_room == 0 ? ""
                                               : fmt::format("; {} {} without room", route.without_room,
                                                             route.without_room == 1 ? "leg" : "legs"));
  }
  return out;
}

ordered_json route_json(const Plan& plan) {
  assert(plan.route.planned());
  const Route& route = plan.route;
  const RouteSums sums = sums_of(route);
  ordered_json legs = ordered_json::array();
  for (const RouteLeg& leg : route.legs) legs.push_back(leg_json(leg, legs.size() + 1));
  return {{"legs", std::move(legs)},
          {"length_m", sums.length_m},
          {"working_m", sums.working_m},
          {"headland_m", sums.headland_m},
          {"turning_m", sums.turning_m},
          {"transit_m", sums.transit_m},
          {"reverse_m", sums.reverse_m},
          {"time_s", sums.time_s},
          {"back_outs", sums.back_outs},
          {"stop_s", route.proof.stop_s},
          {"bound_s", route.proof.bound_s},
          {"gap", gap(priced_time_s(route), route.proof.bound_s)},
          {"without_room", legs_without_room(route, plan.machine)},
          {"over_worked_m", route.over_worked_m},
          {"over_unworked_m", route.over_unworked_m},
          {"over_tracks_m", route.over_tracks_m}};
}

std::string route_rows(const Plan& plan) {
  if (!plan.route.planned()) return "";
  const RouteSums sums = sums_of(plan.route);
  return first_row(plan, sums) + room_row(plan);
}

std::string whole_cost_row(const Plan& plan) {
  if (!plan.route.planned()) return "";
  const WholeCost cost = whole_cost(plan);
  std::string out = fmt::format("whole cost   {:.2f} €, {:.2f} h: machine {:.2f} €", plain_zero(cost.euros()),
                                cost.time_s() / 3600, plain_zero(cost.hours));
  if (cost.fuel_l > 0) out += fmt::format(", {:.1f} l of fuel {:.2f} €", cost.fuel_l, cost.fuel);
  out += fmt::format(", worked twice {:.2f} €, missed {:.2f} €", plain_zero(cost.overlap),
                     plain_zero(cost.missed));
  if (cost.stops > 0) out += fmt::format(", stops {:.2f} €", cost.stops);
  if (cost.driven_over > 0) out += fmt::format(", crop driven over {:.2f} €", cost.driven_over);
  if (cost.without_room > 0) out += fmt::format(", legs without room {:.2f} €", cost.without_room);
  return out + fmt::format("; field efficiency {:.1f} %\n", 100 * cost.field_efficiency);
}

}  // namespace tramline::app
