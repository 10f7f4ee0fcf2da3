#include "report/plan_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/front_report.h"
#include "report/obstacle_report.h"
#include "report/plan_summary.h"
#include "report/report_parts.h"
#include "report/turning/route_report.h"
#include "report/turning/turning_report.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/headland/body.h"
#include "tramline/model/plain_zero.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

double percent_of_field(const Plan& plan, double part_m2) { return 100 * part_m2 / area_m2(plan.field); }

ordered_json dropped_json(const Plan& plan) {
  ordered_json out = ordered_json::array();
  for (const DroppedPiece& piece : plan.dropped)
    out.push_back({{"subfield", piece.subfield + 1},
                   {"x_m", midpoint(piece.start, piece.end).x},
                   {"y_m", midpoint(piece.start, piece.end).y},
                   {"length_m", distance(piece.start, piece.end)},
                   {"why", name(piece.why)}});
  return out;
}

std::vector<Direction> directions_of(const Plan& plan) {
  std::vector<Direction> out;
  for (const Subfield& subfield : plan.subfields) out.push_back(subfield.direction);
  return out;
}

std::ptrdiff_t given_subfields(const Plan& plan) {
  return std::count_if(plan.subfields.begin(), plan.subfields.end(),
                       [](const Subfield& subfield) { return !subfield.given_by.empty(); });
}

std::string repair_row(const Plan& plan) {
  return fmt::format("search       lines over gaps, ends '{}', boundary {}\n", name(plan.settings.end_rule),
                     name(plan.settings.boundary));
}

std::string ground_rows(const Plan& plan) {
  std::string out;
  out += fmt::format(
      "area         {:.4f} ha without the obstacles, {:.4f} ha of it for tracks\nobstacles    {}, passable "
      "strips {}\n",
      area_m2(plan.field) / 1e4, area(plan.body) / 1e4,
      obstacle_shapes(plan.field, ObstacleKind::kObstacle).size(),
      obstacle_shapes(plan.field, ObstacleKind::kPassable).size());
  out += fmt::format("machine      {}{:g} m wide, turning radius {:g} m\n",
                     plan.machine.name.empty() ? "" : plan.machine.name + ", ", plan.machine.width_m,
                     plan.machine.radius_m);
  if (is_repair(plan)) return out + repair_row(plan);
  out += fmt::format("search       {} strategy, {} directions tried, ends '{}', boundary {}\n",
                     name(plan.settings.strategy), plan.directions_tried, name(plan.settings.end_rule),
                     name(plan.settings.boundary));
  return out;
}

/// How much more than the best possible plan this one may cost, in the unit of the cost: a share would look
/// large for any plan that costs almost nothing.
std::string proof_rows(const Plan& plan) {
  const Proof& proof = plan.proof;
  return fmt::format(
             "bound        no plan costs less than {:.2f}, so a better plan could save {:.2f} at most\n"
             "undivided    the best plan found with one direction costs {:.2f}, and none such costs less "
             "than "
             "{:.2f}\n",
             proof.bound, plain_zero(std::max(0.0, plan.cost - proof.bound)), proof.one_direction_cost,
             proof.one_direction_bound) +
         (proof.prices.cells.empty()
              ? ""
              : fmt::format(
                    "prices       of {} cells of land prove that no plan of tracks costs less than {:.2f}, "
                    "further subfields not counted\n",
                    proof.prices.cells.size(), std::max(0.0, proof.prices.bound)));
}

/// Of tracks and headland passes; infinite where all is straight, and 0 at a kink, m.
double least_radius_m(const Plan& plan) {
  double least = std::numeric_limits<double>::infinity();
  for (const TrackPiece& piece : plan.pieces)
    least = least == 0 || has_kinks(piece.curve) ? 0 : std::min(least, smallest_radius(centre_line(piece)));
  for (const HeadlandPass& pass : plan.headland.passes)
    least = has_kinks(pass.path) ? 0 : std::min(least, smallest_radius(pass.path));
  return least;
}

ordered_json reference_json(const Plan& plan, const Path& reference) {
  if (reference.empty()) return {};
  const std::vector<Point> line = chords(reference, 0.1);
  ordered_json points = ordered_json::array();
  for (const Point p : line) points.push_back({p.x, p.y});
  return {{"source", plan.settings.guide.empty() ? "edge" : "line"},
          {"direction_deg", Direction::along(line.front(), line.back()).degrees()},
          {"points_m", std::move(points)}};
}

void add_map_keys(ordered_json& out, const Plan& plan) {
  const Headland& headland = plan.headland;
  const double radius_m = least_radius_m(plan);
  out["kind"] = kind_of_tracks(plan);
  if (plan.settings.tracks != TrackConstruction::kParallel) out["construction"] = name(plan.settings.tracks);
  if (!plan.settings.guide.empty()) out["ab_anchor"] = name(anchor_of(plan.settings));
  const std::optional<Path> common = common_reference(plan);
  out["reference"] = common ? reference_json(plan, *common) : ordered_json();
  if (!common && !references(plan).empty())
    for (const Subfield& subfield : plan.subfields)
      out["references"].push_back(reference_json(plan, subfield.reference));
  out["min_radius_m"] = std::isfinite(radius_m) ? ordered_json(radius_m) : ordered_json();
  out["identity_error_m2"] = std::abs(identity_error_m2(plan));
  out["headland_passes"] = headland.passes.size();
  out["headland_m2"] = area(headland.ground);
  if (!headland.edge_passes.empty()) out["headland_edge_passes"] = headland.edge_passes;
  out["headland_length_m"] = length(headland);
  out["headland_overlap_m2"] = headland.overlap_m2;
  out["headland_uncovered_m2"] = headland.uncovered_m2;
}

std::string headland_rows(const Plan& plan) {
  const Headland& headland = plan.headland;
  if (headland.passes.empty()) return "";
  return fmt::format(
      "headlands    {} {}, {:.1f} m in all, on {:.4f} ha; overlap {:.1f} m², uncovered {:.1f} m²\n",
      headland.passes.size(), headland.passes.size() == 1 ? "pass" : "passes", length(headland),
      area(headland.ground) / 1e4, headland.overlap_m2, headland.uncovered_m2);
}

std::string radius_remark(double radius_m) {
  if (radius_m == 0) return " with kinks, as in the paper";
  return std::isfinite(radius_m) ? fmt::format(", least radius {:.2f} m", radius_m) : "";
}

std::string line_rows(const Plan& plan) {
  const std::size_t lines = references(plan).size();
  if (lines == 0) return "";
  const std::string edges = lines == 1 ? "an edge of the field" : fmt::format("{} edges of the field", lines);
  return fmt::format("reference    {}, tracks {}{}\n", plan.settings.guide.empty() ? edges : "the line given",
                     kind_of_tracks(plan), radius_remark(least_radius_m(plan)));
}

std::string tally_rows(const Plan& plan) {
  const Tally& tally = plan.tally;
  constexpr std::size_t kShown = 8;
  std::string out;
  out += plan.subfields.empty() ? "subfields    none: headland passes work the field alone\n"
                                : fmt::format("subfields    {} (direction {})\n", plan.subfields.size(),
                                              directions_text(directions_of(plan), kShown));
  if (const std::ptrdiff_t given = given_subfields(plan); given > 0)
    out += fmt::format("drawn        {} of them by hand\n", given);
  out += headland_rows(plan) + line_rows(plan);
  out +=
      fmt::format("tracks       {}, {:.1f} m in all; by themselves overlap {:.1f} m², uncovered {:.1f} m²\n",
                  tally.pieces, tally.track_length_m, plain_zero(plan.track_tally.overlap_m2),
                  plain_zero(plan.track_tally.uncovered_m2));
  out += fmt::format("turns        {}\n", tally.turns);
  out += fmt::format("stops        {}\n", stops(plan));
  out += turning_rows(plan) + route_rows(plan);
  out += obstacle_rows(plan);
  if (tally.crossings > 0) out += fmt::format("crossings    {}\n", tally.crossings);
  out += fmt::format("cost         {:.2f} = {}\n", plan.cost, prices_text(plan.objective));
  if (is_proven(plan)) out += proof_rows(plan);
  return out;
}

void add_proof_keys(ordered_json& out, const Plan& plan) {
  const bool proven = is_proven(plan);
  const Proof& proof = plan.proof;
  out["bound"] = proven ? ordered_json(proof.bound) : ordered_json();
  out["gap"] = proven ? ordered_json(gap(plan.cost, proof.bound)) : ordered_json();
  out["one_direction_cost"] = proven ? ordered_json(proof.one_direction_cost) : ordered_json();
  out["gap_one_direction"] =
      proven ? ordered_json(gap(proof.one_direction_cost, proof.one_direction_bound)) : ordered_json();
  if (!proof.prices.cells.empty())
    out["prices"] = {{"cells", proof.prices.cells.size()}, {"bound", proof.prices.bound}};
  out["cut_short"] = proof.cut_short;
}

}  // namespace

ordered_json plan_json(const Plan& plan, const std::vector<Skipped>& skipped, double seconds) {
  const Tally& tally = plan.tally;
  ordered_json directions = ordered_json::array();
  for (const Subfield& subfield : plan.subfields) directions.push_back(subfield.direction.degrees());
  ordered_json out;
  out["field_id"] = plan.field.id;
  if (is_of_lines(plan)) out["origin"] = name(plan.origin);
  out["area_m2"] = area_m2(plan.field);
  out["body_m2"] = area(plan.body);
  out["obstacles"] = obstacle_shapes(plan.field, ObstacleKind::kObstacle).size();
  out["passable"] = obstacle_shapes(plan.field, ObstacleKind::kPassable).size();
  out["width_m"] = plan.machine.width_m;
  out["radius_m"] = plan.machine.radius_m;
  out["min_length_m"] = min_length_m(plan.machine);
  if (plan.machine.turning != Turning{}) out["turning"] = turning_json(plan.machine.turning);
  out["strategy"] = name(plan.settings.strategy);
  out["end_rule"] = name(plan.settings.end_rule);
  out["boundary"] = name(plan.settings.boundary);
  out["directions_tried"] = plan.directions_tried;
  out["direction_deg"] = std::move(directions);
  out["subfields"] = plan.subfields.size();
  if (given_subfields(plan) > 0)
    for (const Subfield& subfield : plan.subfields) out["given_by"].push_back(subfield.given_by);
  out["further_subfields"] = further_subfields(tally);
  out["tracks"] = tally.pieces;
  out["turns"] = tally.turns;
  out["stops"] = tally.stops;
  out["crossings"] = tally.crossings;
  if (!plan.turns.empty()) out["planned_turns"] = planned_turns_json(plan);
  if (plan.route.planned()) {
    out["route"] = route_json(plan);
    out["whole_cost"] = whole_cost_json(plan);
  }
  out["track_length_m"] = tally.track_length_m;
  out["overlap_m2"] = tally.overlap_m2;
  out["uncovered_m2"] = tally.uncovered_m2;
  out["overlap_pct"] = percent_of_field(plan, tally.overlap_m2);
  out["uncovered_pct"] = percent_of_field(plan, tally.uncovered_m2);
  out["body_overlap_m2"] = plan.track_tally.overlap_m2;
  out["body_uncovered_m2"] = plan.track_tally.uncovered_m2;
  if (plan.left_out > 0) out["left_out_m2"] = area(left_out_land(plan));
  if (!plan.worked.empty() && !is_repair(plan)) out["land_done_m2"] = area(plan.worked);
  out["given_up_m2"] = area(plan.given_up);
  out["cost"] = plan.cost;
  add_map_keys(out, plan);
  add_proof_keys(out, plan);
  out["weights"] = weights_json(plan.objective);
  add_obstacle_keys(out, plan);
  out["repairs"] = repairs_json(plan.field.repairs);
  out["skipped"] = skipped_json(skipped);
  out["dropped"] = dropped_json(plan);
  out["warnings"] = plan.warnings;
  if (!plan.front.points.empty()) out["front"] = front_json(plan.front);
  out["seconds"] = seconds;
  return out;
}

std::string plan_details(const Plan& plan, const std::vector<Skipped>& skipped, double seconds) {
  std::string out = ground_rows(plan) + tally_rows(plan);
  out += fmt::format("time         {:.3f} s\n", seconds);
  for (const Repair& repair : plan.field.repairs)
    out += fmt::format("repaired     {}, {} at ({:.9g}, {:.9g}), area {:+.2f} m²\n", repair.where,
                       repair.what, repair.at.x, repair.at.y, repair.area_change_m2);
  out += skipped_rows(skipped);
  out += note_rows(plan.warnings);
  return out;
}

}  // namespace tramline::app
