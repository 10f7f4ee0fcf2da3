#include "report/turning/turning_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

struct TurningSum {
  int fitting = 0;
  int without_room = 0;
  int apart = 0;
  int gear_changes = 0;
  double length_m = 0;
  double time_s = 0;
  double missing_m = 0;
  double lateral_error_m = 0;
};

TurningSum sum_of(const Plan& plan) {
  TurningSum out;
  for (const PlannedTurn& turn : plan.turns) {
    if (turn.state == TurnState::kApart) {
      ++out.apart;
      continue;
    }
    out.missing_m = std::max(out.missing_m, turn.missing_m);
    if (turn.state == TurnState::kNoRoom) {
      ++out.without_room;
      continue;
    }
    ++out.fitting;
    out.gear_changes += gear_changes(turn.manoeuvre);
    out.length_m += length(turn.manoeuvre.path);
    out.time_s += turn.time_s;
    out.lateral_error_m = std::max(out.lateral_error_m, turn.lateral_error_m);
  }
  return out;
}

double room_beyond_m(const Plan& plan) {
  double out = 0;
  for (const double beyond_m : plan.room_beyond_m) out = std::max(out, beyond_m);
  return out;
}

std::string minutes(double time_s) { return fmt::format("{:.1f} min", time_s / 60); }

}  // namespace

ordered_json planned_turns_json(const Plan& plan) {
  const TurningSum sum = sum_of(plan);
  ordered_json out = {{"planned", plan.turns.size()},
                      {"fitting", sum.fitting},
                      {"without_room", sum.without_room},
                      {"apart", sum.apart},
                      {"gear_changes", sum.gear_changes},
                      {"length_m", sum.length_m},
                      {"time_s", sum.time_s},
                      {"missing_m", sum.missing_m},
                      {"lateral_error_m", sum.lateral_error_m},
                      {"turning_speed_mps", plan.machine.turning.turning_speed_mps},
                      {"reverse_speed_mps", plan.machine.turning.reverse_speed_mps}};
  if (plan.room_beyond_m.empty()) return out;
  ordered_json edges = ordered_json::array();
  const Ring& ring = plan.field.outer;
  for (std::size_t i = 0; i < plan.room_beyond_m.size(); ++i) {
    if (plan.room_beyond_m[i] <= 0) continue;
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    edges.push_back({{"edge", i + 1},
                     {"from_m", {from.x, from.y}},
                     {"to_m", {to.x, to.y}},
                     {"room_m", plan.room_beyond_m[i]}});
  }
  out["room_beyond_boundary"] = std::move(edges);
  return out;
}

std::string turning_rows(const Plan& plan) {
  if (plan.turns.empty()) return "";
  const TurningSum sum = sum_of(plan);
  const Turning& turning = plan.machine.turning;
  std::string out =
      fmt::format("turning      {} of {} turns have room: {:.1f} m, {} at {:g} m/s", sum.fitting,
                  plan.turns.size(), sum.length_m, minutes(sum.time_s), turning.turning_speed_mps);
  if (sum.gear_changes > 0)
    out += fmt::format(" ({:g} m/s in reverse, {} changes of gear of {:g} s)", turning.reverse_speed_mps,
                       sum.gear_changes, turning.gear_change_s);
  out += "\n";
  if (sum.without_room > 0)
    out += fmt::format("no room      for {} turns; they leave the land by up to {:.1f} m\n", sum.without_room,
                       sum.missing_m);
  if (sum.apart > 0)
    out += fmt::format("apart        {} pairs of tracks are too far apart for a turn\n", sum.apart);
  if (sum.lateral_error_m > 0)
    out += fmt::format("towing       the implement is up to {:.2f} m beside its track where work begins\n",
                       sum.lateral_error_m);
  if (const double beyond_m = room_beyond_m(plan); beyond_m > 0)
    out += fmt::format("room needed  turns reach up to {:.1f} m beyond the boundary\n", beyond_m);
  return out;
}

}  // namespace tramline::app
