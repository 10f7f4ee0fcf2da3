#include "tramline/io/plan/route_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/plan/derived_values.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/turn_text.h"

namespace tramline::io {
namespace {

namespace layers = plan_layers;

/// Where the leg is drawn: chords of the way of the axle's middle. A leg too short for a chord is a point,
/// twice.
std::vector<Point> drawn(const RouteLeg& leg, Point before) {
  const Path path = trace(leg.path);
  if (!path.empty()) {
    std::vector<Point> out = chords(path);
    if (out.size() == 1) out.push_back(out.front());
    return out;
  }
  const Point at = leg.path.empty() ? before : leg.path.front().start.at;
  return {at, at};
}

Cell number_from_1(const std::optional<std::size_t>& index) {
  return index ? Cell(static_cast<long long>(*index) + 1) : Cell();
}

/// Numbers less than 1 become indices beyond all others, as those of subfields do.
std::optional<std::size_t> index_of(const Row& row, const char* column) {
  const std::optional<int> number = row.whole_if_any(column);
  return number ? std::optional(static_cast<std::size_t>(*number) - 1) : std::nullopt;
}

template <class Choice>
Choice word(const Row& row, const char* column, std::optional<Choice> choice) {
  if (!choice)
    throw bad_input(fmt::format("{} is '{}', a word that this version of tramline does not know",
                                row.place_of(column), row.text(column)));
  return *choice;
}

std::optional<Gear> gear_named(const std::string& text) {
  for (const Gear gear : {Gear::kForward, Gear::kReverse})
    if (text == name(gear)) return gear;
  return std::nullopt;
}

RouteLeg leg_of(const Row& row) {
  RouteLeg leg;
  leg.kind = word(row, "kind", leg_kind_named(row.text("kind")));
  leg.gear = word(row, "gear", gear_named(row.text("gear")));
  leg.work = row.flag("work");
  leg.path = steered_from_text(row.text("stretches"), row.offset(), row.place_of("stretches"));
  leg.piece = index_of(row, "piece");
  leg.pass = index_of(row, "pass");
  leg.time_s = row.number("time_s");
  leg.missing_m = row.number("missing_m");
  leg.lateral_error_m = row.number("lateral_error_m");
  return leg;
}

using Numbered = std::pair<int, RouteLeg>;

/// Driving order is the order of the numbers, whatever that of the rows is.
void sort_legs(std::vector<Numbered>& rows, const std::string& place) {
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  int expected = 0;
  for (const auto& [number, leg] : rows)
    if (number != ++expected)
      throw bad_input(
          fmt::format("{}: legs are numbered from 1 on, and number {} is not there; write the "
                      "plan again",
                      place, expected));
}

}  // namespace

bool has_route(const Plan& plan) {
  return plan.route.planned() || plan.settings.turns == TurnPlanning::kRoute;
}

void write_route_legs(const Target& target, const Plan& plan) {
  if (!has_route(plan)) return;
  Table table(
      target, layers::kRouteLegs, wkbLineString,
      {integer("seq"), text("kind"), text("gear"), flag("work"), integer("piece"), integer("pass"),
       real("length_m"), real("time_s"), real("missing_m"), real("lateral_error_m"), text("stretches")});
  long long seq = 0;
  Point at = plan.field.outer.empty() ? Point{} : plan.field.outer.front();
  for (const RouteLeg& leg : plan.route.legs) {
    const std::vector<Point> line = drawn(leg, at);
    at = line.back();
    table.add(target.shapes.line(line),
              {++seq, std::string(name(leg.kind)), std::string(name(leg.gear)), leg.work,
               number_from_1(leg.piece), number_from_1(leg.pass), length(leg), leg.time_s, leg.missing_m,
               leg.lateral_error_m, steered_text(leg.path, target.offset)});
  }
}

void read_route_legs(Rows& file, PlanFile& out) {
  if (!file.has(layers::kRouteLegs)) return;
  std::vector<Numbered> rows;
  std::string place;
  file.each(layers::kRouteLegs, [&](const Row& row) {
    rows.emplace_back(row.whole("seq"), leg_of(row));
    derive(out, row, "length_m", length(rows.back().second), row.line().front());
    place = row.place();
  });
  sort_legs(rows, place);
  for (auto& [number, leg] : rows) out.plan.route.legs.push_back(std::move(leg));
}

}  // namespace tramline::io
