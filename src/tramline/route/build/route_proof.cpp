#include "tramline/route/build/route_proof.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tramline/route/axle/axle_path.h"
#include "tramline/route/backing/least_backing.h"
#include "tramline/route/build/least_connections.h"
#include "tramline/route/build/ring_places.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/certificate/best_bound.h"
#include "tramline/route/connection/least_seconds.h"
#include "tramline/route/turning/turning_land.h"
#include "tramline/turns/outline/outline.h"

namespace tramline {
namespace {

/// The places that a machine gets to are followed on routes with stops and no more tracks and open passes.
constexpr std::size_t kMostLinesFollowed = 12;

/// The phases of tracks and of passes that a route works one after the other, by piece and by pass.
struct Phases {
  std::vector<std::size_t> of_pieces;
  std::vector<std::size_t> of_passes;
  std::size_t last = 0;
};

/// Legs along tracks or along passes with none of the others between.
struct Run {
  std::vector<const RouteLeg*> legs{};
  bool on_passes = false;
  bool around_field = false;  ///< one of the passes follows the field's boundary
};

std::vector<Run> runs_of(const std::vector<RouteLeg>& legs, const Headland& headland) {
  std::vector<Run> out;
  for (const RouteLeg& leg : legs) {
    if (!leg.piece && !leg.pass) continue;
    if (out.empty() || out.back().on_passes != leg.pass.has_value())
      out.push_back({{}, leg.pass.has_value()});
    out.back().legs.push_back(&leg);
    if (leg.pass && headland.passes[*leg.pass].around_field) out.back().around_field = true;
  }
  return out;
}

/// Passes between tracks that go round obstacles alone belong to the phase of the tracks.
Phases phases_of(const std::vector<RouteLeg>& legs, std::size_t pieces, const Headland& headland) {
  Phases out{std::vector<std::size_t>(pieces, 0), std::vector<std::size_t>(headland.passes.size(), 0)};
  const std::vector<Run> runs = runs_of(legs, headland);
  const auto among_tracks = [&runs](std::size_t i) {
    return runs[i].on_passes && !runs[i].around_field && i > 0 && i + 1 < runs.size();
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0 && !among_tracks(i - 1) && !among_tracks(i)) ++out.last;
    for (const RouteLeg* leg : runs[i].legs)
      (leg->pass ? out.of_passes[*leg->pass] : out.of_pieces[*leg->piece]) = out.last;
  }
  return out;
}

std::size_t count_pieces(const std::vector<order::WorkedLine>& lines) {
  std::size_t out = 0;
  for (const order::WorkedLine& line : lines) out += line.size();
  return out;
}

/// The lines in driving order, in the sense in which they are driven, the open passes, and the rings.
RouteMembers members_of_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                              const order::Tour& tour, const Route& route) {
  const Turning& turning = task.machine.turning;
  const Headland& headland = task.headland;
  const Phases phases = phases_of(route.legs, count_pieces(lines), headland);
  RouteMembers out;
  std::size_t piece = 0;
  for (const order::End entered : tour) {
    const order::WorkedLine& line = lines[order::line_of(entered)];
    out.lines.push_back(route_line(order::is_start(entered) ? line : order::backwards(line), turning));
    out.line_phases.push_back(phases.of_pieces[piece]);
    piece += line.size();
  }
  // Passes with sharp corners are no rings that a machine could drive along.
  const bool drivable = headland.construction == HeadlandConstruction::kDrivable;
  for (std::size_t i = 0; i < headland.passes.size(); ++i) {
    const HeadlandPass& pass = headland.passes[i];
    if (!is_closed(pass)) {
      out.lines.push_back(route_line(pass, i, turning));
      out.line_phases.push_back(phases.of_passes[i]);
    } else if (drivable) {
      out.rings.push_back(ring_places(pass, turning));
      out.ring_phases.push_back(phases.of_passes[i]);
    }
  }
  const RouteSettings& asked = task.settings.route;
  if (asked.start) out.gates.push_back({*asked.start, 0});
  if (asked.end) out.gates.push_back({*asked.end, phases.last});
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

/// Where all ways have room: a route that leaves the land is not bounded by its sides.
std::optional<LeastBacking> least_backing(const RouteTask& task, const Route& route, std::size_t lines,
                                          double stop_s) {
  const std::optional<double> beyond_m = land_beyond_m(task.settings);
  if (!beyond_m || task.machine.turning.reverse || outline_of(task.machine).tows()) return std::nullopt;
  for (const RouteLeg& leg : route.legs)
    if (leg.missing_m > 0) return std::nullopt;
  const bool followed = lines <= kMostLinesFollowed && sums_of(route).back_outs > 0;
  return LeastBacking(task.field.outer, *beyond_m, slightly_tighter(task.machine), stop_s,
                      followed ? LeastBacking::Places::kFollowed : LeastBacking::Places::kNotFollowed);
}

}  // namespace

RouteProof route_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                       const order::Tour& tour, const Route& route) {
  RouteProof out;
  out.stop_s = counted_stop_s(task);
  const LeastSeconds least(slightly_tighter(task.machine), out.stop_s);
  const double fixed_s = fixed_seconds(route.legs, lines, task.machine.turning);
  const RouteSums sums = sums_of(route);
  const double whole_s = sums.time_s + out.stop_s * static_cast<double>(sums.back_outs);
  RouteMembers members = members_of_proof(task, lines, tour, route);
  const std::size_t count = members.lines.size();
  const LeastConnections bounds(std::move(members), task.machine.width_m, least,
                                least_backing(task, route, count, out.stop_s));
  if (bounds.lines() + bounds.rings() == 0) {
    out.bound_s = fixed_s;
    return out;
  }
  const double change_s = bounds.between_phases_s();
  order::PricedBound priced = order::best_bound(bounds, {std::max(0.0, whole_s - fixed_s) + change_s, 0});
  out.bound_s = fixed_s + std::max(0.0, priced.bound_s - change_s);
  out.node_prices_s = std::move(priced.prices_s);
  return out;
}

}  // namespace tramline
