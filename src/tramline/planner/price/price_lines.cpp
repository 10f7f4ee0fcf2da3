#include "tramline/planner/price/price_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tramline/avoidance/obstacles/obstacle_classification.h"
#include "tramline/cost/settled_areas.h"
#include "tramline/cost/worked/covered_land.h"
#include "tramline/cost/worked/kinked_overlap.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/headland/body.h"
#include "tramline/planner/price/given_layers.h"
#include "tramline/planner/price/given_pieces.h"
#include "tramline/planner/validate_request.h"
#include "tramline/planner/warnings.h"

namespace tramline {
namespace {

/// The lines that have a length, with workable paths and subfields numbered from 0 without gaps; the others
/// are listed.
std::vector<GivenLine> workable(const std::vector<GivenLine>& lines, double width_m, Rings rings,
                                std::vector<Skipped>& skipped) {
  std::vector<GivenLine> out;
  std::set<int> numbers;
  for (const GivenLine& line : lines) {
    std::optional<Path> path = workable_path(line.path, width_m, rings);
    if (!path) {
      skipped.push_back({"line", line.name, "it has no length"});
      continue;
    }
    out.push_back(line);
    out.back().path = *std::move(path);
    numbers.insert(line.subfield);
  }
  for (GivenLine& line : out)
    line.subfield = static_cast<int>(std::distance(numbers.begin(), numbers.find(line.subfield)));
  return out;
}

std::vector<Path> paths_of(const std::vector<GivenLine>& lines) {
  std::vector<Path> out;
  for (const GivenLine& line : lines) out.push_back(line.path);
  return out;
}

CoveringSwath covering(const Path& path) {
  return {path, has_smooth_edges(path) ? SwathEdges::kSmooth : SwathEdges::kMitred};
}

/// The axis of all lines, each metre of them counted; north where they have none.
Direction main_axis(const std::vector<const Path*>& paths) {
  Point doubled{0, 0};  // headings counted twice, so that both ways along an axis are one
  for (const Path* path : paths)
    for (const PathSegment& segment : *path) {
      const Point d = segment.to - segment.from;
      const double metres = std::max(length(d), kShortest_m);
      doubled = doubled + (1 / metres) * Point{d.x * d.x - d.y * d.y, 2 * d.x * d.y};
    }
  const double angle = 0.5 * std::atan2(doubled.y, doubled.x);
  return Direction::along({0, 0}, {std::cos(angle), std::sin(angle)});
}

std::vector<Subfield> subfields_of(const std::vector<GivenLine>& lines, double width_m, const Region& land) {
  std::vector<std::vector<const Path*>> by_number;
  for (const GivenLine& line : lines) {
    const auto number = static_cast<std::size_t>(line.subfield);
    if (number >= by_number.size()) by_number.resize(number + 1);
    by_number[number].push_back(&line.path);
  }
  std::vector<Subfield> out;
  for (const std::vector<const Path*>& paths : by_number)
    out.push_back({land_about(paths, width_m, land), main_axis(paths)});
  return out;
}

/// The area of the passables that the passes drive over, each time counted: the work is interrupted there.
double on_passables_m2(const std::vector<Path>& passes, const Region& passable, double width_m) {
  if (passable.empty()) return 0;
  double sum_m2 = 0;
  for (const Path& path : passes)
    for (const PathSegment& segment : path)
      sum_m2 += covered_m2({{{segment}, SwathEdges::kSmooth}}, {&passable}, width_m,
                           Direction::along(segment.from, segment.to));
  return sum_m2;
}

void set_headland(const std::vector<Path>& passes, const Region& land, Plan& plan) {
  plan.body = land;
  if (passes.empty()) return;
  const double width_m = plan.machine.width_m;
  for (const Path& path : passes) {
    HeadlandPass pass;
    pass.path = path;
    plan.headland.passes.push_back(std::move(pass));
    plan.headland.worked_m2 += width_m * length(path);
  }
  const Region passable = unite(obstacle_shapes(plan.field, ObstacleKind::kPassable));
  plan.headland.worked_m2 -= on_passables_m2(passes, passable, width_m);
  plan.headland.ground = intersection(unite(swath_grounds(passes, width_m, kChordSagitta)), land);
  plan.body = difference(land, plan.headland.ground);
  plan.headland.overlap_m2 = std::max(0.0, plan.headland.worked_m2 - area(plan.headland.ground));
}

/// Counts and lengths.
Tally counted(const Plan& plan) {
  Tally out;
  std::set<std::size_t> subfields;
  for (const TrackPiece& piece : plan.pieces) {
    out.track_length_m += length(piece);
    out.crossings += piece.after_crossing ? 1 : 0;
    out.stops += (piece.stop_at_start ? 1 : 0) + (piece.stop_at_end ? 1 : 0);
    subfields.insert(piece.subfield);
  }
  out.worked_m2 = plan.machine.width_m * out.track_length_m;
  out.pieces = static_cast<int>(plan.pieces.size());
  out.turns = std::max(0, out.pieces - 1 - out.crossings);
  out.subfields = static_cast<int>(subfields.size());
  return out;
}

void set_figures_of_lines(const std::vector<Path>& tracks, const std::vector<Path>& passes, Plan& plan) {
  const double width_m = plan.machine.width_m;
  const Region& body = plan.body;
  const Region& ground = plan.headland.ground;
  std::vector<CoveringSwath> swaths;
  std::vector<const Path*> all;
  for (const Path& path : tracks) {
    swaths.push_back(covering(path));
    all.push_back(&path);
  }
  const Direction main = main_axis(all);
  Tally tally = counted(plan);
  settle_areas(tally, covered_m2(swaths, {&body}, width_m, main), area(body));
  plan.track_tally = tally;
  if (!passes.empty()) {
    for (const Path& path : passes) swaths.push_back(covering(path));
    tally.worked_m2 += plan.headland.worked_m2;
    settle_areas(tally, covered_m2(swaths, {&body, &ground}, width_m, main), area(body) + area(ground));
  }
  plan.tally = tally;
  plan.cost = cost(plan.objective, tally);
}

/// What each line works in vain is known in closed form of lines without arcs.
void set_overlap_by_line(Plan& plan) {
  const bool arcs =
      std::ranges::any_of(plan.pieces, [](const TrackPiece& piece) { return has_arcs(centre_line(piece)); });
  if (arcs) return;
  const std::vector<double> overlaps = overlap_by_kinked_piece(plan.body, plan.pieces, plan.machine.width_m);
  for (std::size_t i = 0; i < overlaps.size(); ++i) plan.pieces[i].overlap_m2 = overlaps[i];
}

std::vector<std::string> warnings_about_lines(const Plan& plan, const std::vector<Path>& paths) {
  const double width_m = plan.machine.width_m;
  std::vector<std::string> out;
  if (std::string unworked = unworked_land_warning(plan); !unworked.empty())
    out.push_back(std::move(unworked));
  out.insert(out.end(), plan.field.warnings.begin(), plan.field.warnings.end());
  const Region whole{{plan.field.outer, {}}};
  const Region obstacles = unite(obstacle_shapes(plan.field, ObstacleKind::kObstacle));
  std::size_t outside = 0, across = 0;
  double across_m2 = 0;
  constexpr double kWorthSaying_m2 = 0.05;
  for (const Path& path : paths) {
    const Direction along = main_axis({&path});
    if (covered_m2({covering(path)}, {&whole}, width_m, along) <= 0) ++outside;
    const double on_obstacles_m2 = covered_m2({covering(path)}, {&obstacles}, width_m, along);
    if (on_obstacles_m2 > kWorthSaying_m2) ++across;
    across_m2 += on_obstacles_m2;
  }
  if (outside > 0)
    out.push_back(fmt::format("{} of {} lines {} nothing of the field: all {} is overlap", outside,
                              paths.size(), outside == 1 ? "works" : "work",
                              outside == 1 ? "its work" : "their work"));
  if (across > 0)
    out.push_back(fmt::format("the swaths of {} {} work {:.1f} m² of obstacles", across,
                              across == 1 ? "line" : "lines", across_m2));
  return out;
}

Error no_line_with_length(const GivenLines& lines) {
  const std::size_t count = lines.tracks.size() + lines.passes.size();
  return bad_input(fmt::format(
      "{}: draw each line through two different points at least",
      count == 1 ? "the only line has no length" : fmt::format("none of the {} lines has a length", count)));
}

Error all_outside(const Plan& plan) {
  return bad_input(
      fmt::format("the lines lie outside field '{}': no swath {:g} m wide reaches it; give the field that "
                  "they were drawn "
                  "for, or the coordinate reference system of its file with --crs",
                  plan.field.id, plan.machine.width_m));
}

}  // namespace

PricedLines price_lines(const Field& field, const Machine& machine, const Objective& objective,
                        const GivenLines& lines, double clearance_m) {
  PricedLines out;
  Plan& plan = out.plan;
  plan.origin = PlanOrigin::kLines;
  plan.field = field;
  plan.machine = machine;
  plan.objective = objective;
  plan.settings.clearance_m = clearance_m;
  validate_request(machine, objective, plan.settings);
  const double width_m = machine.width_m;
  const std::vector<GivenLine> tracks = workable(lines.tracks, width_m, Rings::kAreOpened, out.skipped);
  const std::vector<Path> passes = paths_of(workable(lines.passes, width_m, Rings::kStay, out.skipped));
  std::vector<Path> all = paths_of(tracks);
  const std::vector<Path> centre_lines = all;
  all.insert(all.end(), passes.begin(), passes.end());
  if (all.empty()) throw no_line_with_length(lines);
  const ClassifiedGround ground = classify_obstacles(field, width_m, clearance_m);
  plan.given_up = ground.given_up;
  plan.pieces = given_pieces(tracks, ground.hard, ground.passable, width_m);
  const Region land = body_of(field);
  plan.subfields = subfields_of(tracks, width_m, ground.plannable.empty() ? land : ground.plannable);
  set_headland(passes, land, plan);
  set_figures_of_lines(centre_lines, passes, plan);
  if (!(plan.tally.uncovered_m2 < area(land))) throw all_outside(plan);
  set_overlap_by_line(plan);
  add_layers_of_lines(centre_lines, passes, plan);
  plan.warnings = warnings_about_lines(plan, all);
  plan.warnings.insert(plan.warnings.end(), lines.notes.begin(), lines.notes.end());
  return out;
}

}  // namespace tramline
