#include "tramline/render/page/legend_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/geometry/path/kinked_line.h"
#include "tramline/model/detour_summary.h"
#include "tramline/render/page/visible_faults.h"
#include "tramline/render/stops/stop_places.h"

namespace tramline::render {
namespace {

constexpr std::size_t kMostSubfieldRows = 12;

bool has(const Field& field, ObstacleKind kind) {
  return std::any_of(field.obstacles.begin(), field.obstacles.end(),
                     [&](const Obstacle& obstacle) { return obstacle.kind == kind; });
}

// Small areas with a decimal: a sliver of 0.4 m² is not nothing.
std::string square_metres(double area_m2) {
  return area_m2 != 0 && area_m2 < 100 ? fmt::format("{:.1f} m²", area_m2)
                                       : fmt::format("{:.0f} m²", area_m2);
}

std::string square_metres_with_share(double area_m2, double whole_m2) {
  if (whole_m2 <= 0) return square_metres(area_m2);
  return fmt::format("{} · {:.2f} %", square_metres(area_m2), 100 * area_m2 / whole_m2);
}

LegendBlock symbols(const Plan& plan) {
  LegendBlock block{"Legend", {}};
  const auto add = [&](bool occurs, Symbol symbol, const char* text) {
    if (occurs) block.rows.push_back({symbol, 0, text, ""});
  };
  add(true, Symbol::kField, "field");
  add(has(plan.field, ObstacleKind::kObstacle), Symbol::kObstacle, "obstacle");
  add(has(plan.field, ObstacleKind::kPassable), Symbol::kPassable, "passable obstacle, not worked");
  add(!plan.worked.empty(), Symbol::kCovered,
      is_repair(plan) ? "worked before, or left for good" : "done, or not to be worked");
  add(!plan.headland.ground.empty(), Symbol::kHeadland, "headland");
  add(!plan.headland.passes.empty(), Symbol::kHeadlandPass, "headland pass");
  add(!plan.given_up.empty(), Symbol::kGivenUp, "given up on purpose (uncovered)");
  add(!plan.pieces.empty(), Symbol::kTrack, "track, number at its start");
  add(summary_of_detours(plan).count() > 0, Symbol::kDetour, "detour round an obstacle");
  const auto turns = [&](auto shown) { return std::any_of(plan.turns.begin(), plan.turns.end(), shown); };
  add(turns([](const PlannedTurn& turn) { return turn.state == TurnState::kFits; }), Symbol::kTurn,
      "turn, way of the axle");
  add(turns([](const PlannedTurn& turn) {
        return turn.state == TurnState::kFits && gear_changes(turn.manoeuvre) > 0;
      }),
      Symbol::kTurnInReverse, "turn, in reverse");
  add(turns([](const PlannedTurn& turn) { return turn.state == TurnState::kNoRoom; }), Symbol::kNoRoom,
      "turn without room");
  const auto legs = [&](auto shown) { return std::ranges::any_of(plan.route.legs, shown); };
  const auto kind = [](LegKind wanted) {
    return [wanted](const RouteLeg& leg) { return leg.kind == wanted && leg.missing_m == 0; };
  };
  add(legs(kind(LegKind::kTurn)), Symbol::kTurn, "turn, way of the axle");
  add(legs(kind(LegKind::kTransit)), Symbol::kTransit, "transit, work off");
  add(legs(kind(LegKind::kBackOut)), Symbol::kBackOut, "backing out or in, in reverse");
  add(legs([](const RouteLeg& leg) { return !leg.work && leg.missing_m > 0; }), Symbol::kNoRoom,
      "way without room");
  add(plan.route.planned(), Symbol::kRouteStart, "the route starts");
  add(plan.route.planned(), Symbol::kRouteEnd, "the route ends");
  add(!references(plan).empty(), Symbol::kReference, "line that tracks follow");
  add(!plan.dropped.empty(), Symbol::kDropped, "dropped: not worth driving");
  add(!stop_places(plan).empty(), Symbol::kStop, "stop: the machine backs out");
  add(!visible_faults(plan.overlap).empty(), Symbol::kOverlap, "overlap");
  const bool unworked = !visible_faults(plan.headland.unworked).empty();
  add(unworked || !visible_faults(plan.uncovered).empty(), Symbol::kUncovered, "uncovered");
  return block;
}

// Of all curved tracks; infinite without arcs, 0 at a kink.
double smallest_radius_m(const Plan& plan) {
  double out = std::numeric_limits<double>::infinity();
  for (const TrackPiece& piece : plan.pieces)
    out = out == 0 || has_kinks(piece.curve) ? 0 : std::min(out, smallest_radius(piece.curve));
  return out;
}

std::string radius_text(const Plan& plan) {
  const double radius_m = smallest_radius_m(plan);
  if (radius_m == 0) return "none: tracks have kinks";
  return std::isfinite(radius_m) ? fmt::format("{:.1f} m", radius_m) : std::string("none");
}

// Apart from the tracks' numbers, which are about the body.
LegendBlock headland_numbers(const Plan& plan) {
  const Headland& headland = plan.headland;
  const double field_m2 = area_m2(plan.field);
  LegendBlock block{"Headland", {}};
  const auto add = [&](const char* text, std::string value) {
    block.rows.push_back({Symbol::kNone, 0, text, std::move(value)});
  };
  add("headland", square_metres_with_share(area(headland.ground), field_m2));
  add("passes", std::to_string(headland.passes.size()));
  add("length of passes", length_text(length(headland)));
  add("worked twice or beyond", square_metres_with_share(headland.overlap_m2, field_m2));
  add("left unworked", square_metres_with_share(headland.uncovered_m2, field_m2));
  return block;
}

LegendBlock numbers(const Plan& plan) {
  const Tally& tally = plan.tally;
  const double field_m2 = area_m2(plan.field);
  LegendBlock block{"Numbers", {}};
  const auto add = [&](const char* text, std::string value) {
    block.rows.push_back({Symbol::kNone, 0, text, std::move(value)});
  };
  add("field", area_text(field_m2));
  add("body", area_text(area(plan.body)));
  add("working width", fmt::format("{:g} m", plan.machine.width_m));
  if (!plan.pieces.empty()) {
    add("tracks", std::to_string(tally.pieces));
    if (is_curved(plan)) {
      add("kind of tracks", kind_of_tracks(plan));
      add("smallest radius", radius_text(plan));
    }
    add("track length", length_text(tally.track_length_m));
    add("turns", std::to_string(tally.turns));
    add("stops", std::to_string(stops(plan)));
    if (const int detours = summary_of_detours(plan).count(); detours > 0)
      add("detours", std::to_string(detours));
    if (tally.crossings > 0) add("crossings", std::to_string(tally.crossings));
    add("overlap", square_metres_with_share(tally.overlap_m2, field_m2));
    add("uncovered", square_metres_with_share(tally.uncovered_m2, field_m2));
    if (!plan.route.planned()) add("cost", fmt::format("{:.2f}", plan.cost));
  }
  if (plan.route.planned()) {
    const WholeCost cost = whole_cost(plan);
    add("hours", fmt::format("{:.2f} h", cost.time_s() / 3600));
    if (cost.fuel_l > 0) add("fuel", fmt::format("{:.1f} l", cost.fuel_l));
    add("whole cost", fmt::format("{:.2f} €", cost.euros()));
  }
  return block;
}

LegendBlock directions(const Plan& plan) {
  LegendBlock block{plan.subfields.size() == 1 ? "Direction" : "Subfields", {}};
  // Curved tracks have a direction as a whole only.
  const std::vector<int> curved = curved_tracks_by_subfield(plan);
  const std::size_t n = plan.subfields.size();
  const std::size_t shown = n > kMostSubfieldRows ? kMostSubfieldRows - 1 : n;
  for (std::size_t i = 0; i < shown; ++i) {
    const Subfield& subfield = plan.subfields[i];
    const double degrees = subfield.direction.degrees();
    const char* const about = curved[i] > 0 ? "about " : "";
    block.rows.push_back({Symbol::kSubfield, static_cast<int>(i),
                          std::isfinite(degrees) ? fmt::format("{}{:.1f}° from north", about, degrees)
                                                 : std::string("no direction"),
                          area_text(area(subfield.shape))});
  }
  if (shown < n) block.rows.push_back({Symbol::kNone, 0, fmt::format("and {} more", n - shown), ""});
  return block;
}

}  // namespace

std::string area_text(double area_m2) {
  return area_m2 < 1000 ? square_metres(area_m2) : fmt::format("{:.2f} ha", area_m2 / 1e4);
}

std::string length_text(double length_m) {
  return length_m < 1000 ? fmt::format("{:.0f} m", length_m) : fmt::format("{:.2f} km", length_m / 1e3);
}

std::vector<LegendBlock> legend_of(const Plan& plan) {
  std::vector<LegendBlock> blocks{symbols(plan), numbers(plan)};
  if (!plan.headland.passes.empty()) blocks.push_back(headland_numbers(plan));
  if (!plan.subfields.empty()) blocks.push_back(directions(plan));
  return blocks;
}

}  // namespace tramline::render
