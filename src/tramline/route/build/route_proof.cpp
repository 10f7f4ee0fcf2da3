#include "tramline/route/build/route_proof.h"

#include <algorithm>

#include "tramline/route/axle/axle_path.h"
#include "tramline/route/build/least_connections.h"
#include "tramline/route/build/least_seconds.h"
#include "tramline/route/build/ring_places.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/certificate/best_bound.h"

namespace tramline {
namespace {

/// The lines in driving order, in the sense in which they are driven, and the open passes.
std::vector<RouteLine> lines_of_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                                      const order::Tour& tour) {
  const Turning& turning = task.machine.turning;
  std::vector<RouteLine> out;
  for (const order::End entered : tour) {
    const order::WorkedLine& line = lines[order::line_of(entered)];
    out.push_back(route_line(order::is_start(entered) ? line : order::backwards(line), turning));
  }
  for (std::size_t i = 0; i < task.headland.passes.size(); ++i)
    if (!is_closed(task.headland.passes[i])) out.push_back(route_line(task.headland.passes[i], i, turning));
  return out;
}

std::vector<RingPlaces> rings_of_proof(const Headland& headland, const Turning& turning) {
  std::vector<RingPlaces> out;
  // Passes with sharp corners are no rings that a machine could drive along.
  if (headland.construction != HeadlandConstruction::kDrivable) return out;
  for (const HeadlandPass& pass : headland.passes)
    if (is_closed(pass)) out.push_back(ring_places(pass, turning));
  return out;
}

RouteMembers members_of_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                              const order::Tour& tour) {
  RouteMembers out;
  out.lines = lines_of_proof(task, lines, tour);
  out.tracks = tour.size();
  out.rings = rings_of_proof(task.headland, task.machine.turning);
  const RouteSettings& asked = task.settings.route;
  const bool has_passes = out.lines.size() > out.tracks || !out.rings.empty();
  const auto passes_at = [&](PassTime time) {
    return has_passes && (out.tracks == 0 || asked.passes == time);
  };
  if (asked.start) out.gates.push_back({*asked.start, passes_at(PassTime::kFirst)});
  if (asked.end) out.gates.push_back({*asked.end, passes_at(PassTime::kLast)});
  return out;
}

/// The ways straight on across passable obstacles within lines, m.
double crossings_m(const std::vector<order::WorkedLine>& lines, const Turning& turning) {
  double out = 0;
  for (const order::WorkedLine& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      out +=
          distance(end_of(axle_path(line[i - 1], turning)).at, axle_path(line[i], turning).front().start.at);
  return out;
}

/// Work, headland passes, and crossings of passable obstacles on both: the same on every route.
double fixed_seconds(const std::vector<RouteLeg>& legs, const std::vector<order::WorkedLine>& lines,
                     const Turning& turning) {
  double out = crossings_m(lines, turning) / turning.turning_speed_mps;
  for (const RouteLeg& leg : legs) {
    if (leg.work)
      out += length(leg) / turning.working_speed_mps;
    else if (leg.pass)
      out += length(leg) / turning.turning_speed_mps;
  }
  return out;
}

}  // namespace

RouteProof route_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                       const order::Tour& tour, const Route& route) {
  const LeastSeconds least(task.machine);
  RouteProof out;
  const double fixed_s = fixed_seconds(route.legs, lines, task.machine.turning);
  double whole_s = 0;
  for (const RouteLeg& leg : route.legs) whole_s += leg.time_s;
  const LeastConnections bounds(members_of_proof(task, lines, tour), task.machine.width_m, least);
  if (bounds.lines() + bounds.rings() == 0) {
    out.bound_s = fixed_s;
    return out;
  }
  const double change_s = bounds.between_tracks_and_passes_s();
  order::PricedBound priced = order::best_bound(bounds, {std::max(0.0, whole_s - fixed_s) + change_s, 0});
  out.bound_s = fixed_s + std::max(0.0, priced.bound_s - change_s);
  out.node_prices_s = std::move(priced.prices_s);
  return out;
}

}  // namespace tramline
