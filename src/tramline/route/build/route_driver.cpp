#include "tramline/route/build/route_driver.h"

#include <utility>

#include "tramline/route/passes/pass_tour.h"

namespace tramline {

std::pair<std::size_t, double> effort(const RouteSoFar& route, std::optional<Point> ahead,
                                      const LeastSeconds& least) {
  const bool goes_on = ahead && !route.left.empty();
  return {route.lacking, route.cost_s + (goes_on ? least.to_gate(*ahead, end_of(route.left)) : 0)};
}

RouteDriver::RouteDriver(const RouteTask& task, const RouteContext& context, std::optional<Point> start)
    : task_(task), context_(context), start_(start), so_far_{LegList(task.field, task.machine.turning)} {}

Way RouteDriver::way_to(const SteeredPath& work) const {
  if (!so_far_.left.empty()) return context_.connector.between(so_far_.left, work);
  return start_ ? context_.connector.from_gate(*start_, work) : Way{};
}

Way RouteDriver::as_driven(Way way, const SteeredPath& work) {
  const SteeredPath& left = so_far_.left;
  if (!left.empty() && way.has_room() && (way.backs_out || way.backs_in))
    way = context_.connector.with_less_backing(way, left, work);
  way = context_.connector.measured(std::move(way));
  return way.has_room() || left.empty() ? way : context_.squeezed.along_the_land(std::move(way), left, work);
}

void RouteDriver::add(const Way& way) {
  if (!way.path.empty()) so_far_.legs.add(way);
  so_far_.cost_s += way.cost_s;
  if (!way.has_room()) ++so_far_.lacking;
}

void RouteDriver::follow(const Way& way, const SteeredPath& work) {
  add(way);
  so_far_.left = driven_forward(so_far_.left, way, work);
  so_far_.leaves_part = false;
}

void RouteDriver::drive_line(const Way& way, order::End entered) {
  const DrivenSense& sense = sense_of(entered);
  const order::WorkedLine& line = context_.lines[order::line_of(entered)];
  follow(way, sense.first);
  so_far_.legs.add(order::is_start(entered) ? line : order::backwards(line), so_far_.pieces);
  if (line.size() > 1) so_far_.left = sense.last;
  so_far_.pieces += line.size();
  so_far_.tour.push_back(entered);
}

bool RouteDriver::drive_pass(Way way, std::size_t pass, const PassEntry& entry) {
  const HeadlandPass& of = task_.headland.passes[pass];
  const SteeredPath axle = axle_path(of, entry, task_.machine.turning);
  const double cost_s = way.cost_s;
  way = as_driven(std::move(way), axle);
  follow(way, axle);
  so_far_.legs.add(of, pass, entry);
  return way.cost_s == cost_s;
}

void RouteDriver::drive_passes(const PassGroup& group) {
  bool as_found = true;  // the ways so far, along which the next one may back
  for (WorkedPass& worked : pass_tour(pass_task(group), so_far_.left)) {
    const SteeredPath axle =
        axle_path(task_.headland.passes[worked.pass], worked.entry, task_.machine.turning);
    const bool holds = !worked.before.path.empty() && (as_found || !worked.before.backs_out);
    if (!drive_pass(holds ? std::move(worked.before) : way_to(axle), worked.pass, worked.entry))
      as_found = false;
  }
}

void RouteDriver::drive_to(Point gate) {
  if (so_far_.left.empty()) return;
  add(context_.connector.measured(context_.connector.to_gate(so_far_.left, gate)));
}

PassTask RouteDriver::pass_task(const PassGroup& group) const {
  return {task_.headland,     context_.entries, group.passes, task_.settings.route.sequence,
          context_.connector, context_.least,   group.ahead};
}

}  // namespace tramline
