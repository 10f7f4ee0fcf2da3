#include "tramline/planner/assembly/driven_tracks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/route/build/route_proof.h"
#include "tramline/route/order/best_tour.h"

namespace tramline {
namespace {

bool is_bent(const Path& reference) { return reference.size() > 1 || !reference.front().straight(); }

/// The piece has a path, even a straight one, if its track belongs to a curve; Zhou's tracks along a straight
/// line have none.
bool is_written_as_curve(const SearchTask& task, const Subfield& subfield) {
  if (subfield.reference.empty()) return false;
  return task.settings.tracks == TrackConstruction::kParallel || is_bent(subfield.reference);
}

TrackPiece piece_on_field(const LaidPiece& piece, const StripGrid& grid, std::size_t subfield,
                          int first_track) {
  const auto on_field = [&grid](Point p) { return grid.frame.to_field(p); };
  const Path line = line_of(piece, grid);
  TrackPiece out;
  out.start = line.front().from;
  out.end = line.back().to;
  out.subfield = subfield;
  out.track = piece.track - first_track;
  out.stop_at_start = piece.stop_at_from;
  out.stop_at_end = piece.stop_at_to;
  out.after_crossing = piece.after_crossing;
  for (const TrackDetour& detour : piece.detours)
    out.detours.push_back({moved(detour.path, on_field), detour.side, detour.obstacles});
  return out;
}

/// Neighbouring tracks, and those about two radii away, where a U is shortest.
std::vector<std::size_t> jumps_worth_trying(const Machine& machine) {
  const auto most = static_cast<std::size_t>(std::ceil(2 * machine.radius_m / machine.width_m));
  std::vector<std::size_t> out{1};
  for (std::size_t jump = std::max<std::size_t>(2, most - std::min<std::size_t>(most, 1)); jump <= most + 1;
       ++jump)
    out.push_back(jump);
  return out;
}

/// The indices of the pieces of each line, for pieces in consecutive order.
std::vector<std::vector<std::size_t>> piece_indices_by_line(const std::vector<order::WorkedLine>& lines) {
  std::vector<std::vector<std::size_t>> out;
  std::size_t next = 0;
  for (const order::WorkedLine& line : lines) {
    out.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i) out.back().push_back(next++);
  }
  return out;
}

/// Lands as wide that their jumps are about as long as those worth trying, or half as long again.
std::vector<std::size_t> lands_worth_trying(const Machine& machine) {
  const auto jump = static_cast<std::size_t>(std::ceil(2 * machine.radius_m / machine.width_m));
  if (jump < 2) return {};
  return {2 * jump, 3 * jump};
}

/// The route, with tours of several spacings to begin from. `tour`: the one that the settings ask for.
PlannedRoute route_over(const SearchTask& task, const std::vector<order::WorkedLine>& lines,
                        const order::Tour& tour) {
  std::vector<order::Tour> given{tour};
  const double width_m = task.machine.width_m;
  if (task.settings.route.order == TrackOrder::kBest) {
    for (const std::size_t jump : jumps_worth_trying(task.machine))
      given.push_back(order::skip_tour(lines, task.field, width_m, jump));
    for (const std::size_t land : lands_worth_trying(task.machine))
      given.push_back(order::land_tour(lines, task.field, width_m, land));
  }
  return planned_route({task.field, task.machine, task.settings, task.headland, task.ground.body,
                        task.turning_land, task.beside_boundaries, task.for_narrower, task.patience},
                       lines, given);
}

}  // namespace

DroppedFor why_dropped(const LaidPiece& piece, const Machine& machine) {
  return piece.length_m < min_length_m(machine) ? DroppedFor::kShort : DroppedFor::kWay;
}

Path line_of(const LaidPiece& piece, const StripGrid& grid) {
  const auto on_field = [&grid](Point p) { return grid.frame.to_field(p); };
  if (!piece.path.empty()) return moved(piece.path, on_field);
  const double across = grid.centre(piece.track);
  return {{on_field({across, piece.from}), on_field({across, piece.to}), 0}};
}

std::vector<TrackPiece> track_pieces(const SearchTask& task, const Candidate& candidate) {
  std::vector<TrackPiece> out;
  for (std::size_t i = 0; i < candidate.avoided.tracks.size(); ++i) {
    const LaidTracks& tracks = candidate.avoided.tracks[i];
    const int first = first_track(candidate, i);
    const bool curved = is_written_as_curve(task, candidate.subfields[i]);
    for (const LaidPiece& piece : tracks.pieces) {
      out.push_back(piece_on_field(piece, tracks.grid, i, first));
      if (!curved) continue;
      out.back().curve = line_of(piece, tracks.grid);
      out.back().overlap_m2 = task.machine.width_m * piece.length_m - piece.inside_m2;
    }
  }
  return out;
}

Driven driven_tracks(const SearchTask& task, const Candidate& candidate) {
  std::vector<LaidIndex> laid;
  for (std::size_t i = 0; i < candidate.avoided.tracks.size(); ++i)
    for (std::size_t k = 0; k < candidate.avoided.tracks[i].pieces.size(); ++k) laid.push_back({i, k});
  const std::vector<order::WorkedLine> lines = order::lines_of(track_pieces(task, candidate));
  const std::vector<std::vector<std::size_t>> piece_indices = piece_indices_by_line(lines);
  const double width_m = task.machine.width_m;
  const auto skip = static_cast<std::size_t>(task.settings.skip);
  order::Tour tour = skip > 1 ? order::skip_tour(lines, task.field, width_m, skip)
                              : order::best_tour(lines, task.field, width_m);
  std::optional<PlannedRoute> route;
  if (task.settings.turns == TurnPlanning::kRoute) {
    route = route_over(task, lines, tour);
    tour = route->tour;
  }
  Driven out;
  out.pieces = order::pieces_on(tour, lines);
  out.route = std::move(route);
  for (const order::End end : tour) {
    std::vector<std::size_t> along = piece_indices[order::line_of(end)];
    if (!order::is_start(end)) std::reverse(along.begin(), along.end());
    for (const std::size_t index : along) {
      out.laid.push_back(laid[index]);
      out.back.push_back(!order::is_start(end));
    }
  }
  out.tour = std::move(tour);
  return out;
}

RouteProof proof_of_route(const SearchTask& task, const Candidate& candidate, const order::Tour& tour,
                          const Plan& plan) {
  const RouteTask of_route{task.field,       task.machine,      plan.settings,          task.headland,
                           task.ground.body, task.turning_land, task.beside_boundaries, task.for_narrower};
  return route_proof(of_route, order::lines_of(track_pieces(task, candidate)), tour, plan.route);
}

}  // namespace tramline
