#include "options/plan_options.h"

#include <fmt/format.h>

namespace tramline::app {
namespace {

void add_obstacle_options(Verb& verb, PlanOptions& o) {
  const char* obstacles = "Obstacles";
  verb.add_option("--avoid", o.avoid,
                  "what a track does at an obstacle: cheapest of going round it and cutting, paper (S1's "
                  "rule) or cut (default cheapest)")
      .group(obstacles);
  verb.add_option("--avoid-threshold", o.avoid_threshold_m,
                  "with --avoid paper: tracks go round what is narrower across them, m (default w)")
      .group(obstacles);
  verb.add_option("--clearance", o.clearance_m, "land kept free between swaths and obstacles, m (default 0)")
      .group(obstacles);
}

void add_map_options(Verb& verb, PlanOptions& o) {
  const char* headlands = "Headlands";
  verb.add_option("--headlands", o.headlands,
                  "passes round the field before the tracks; nothing leaves the field then (default 0)")
      .in_range(0, 100)
      .group(headlands);
  verb.add_option("--obstacle-headlands", o.obstacle_headlands,
                  "passes round each obstacle that tracks do not go round (default 0)")
      .in_range(0, 100)
      .group(headlands);
  const char* lines = "Tracks along a line";
  Option ab =
      verb.add_option("--ab", o.ab,
                      "straight tracks along the line through two points, \"x1,y1 x2,y2\", in the field's "
                      "coordinates or in longitude and latitude; it is the border of the first swath");
  Option guide =
      verb.add_option("--guide", o.guide_file,
                      "tracks along the line in this vector file: parallel curves where it has bends");
  Option where =
      verb.add_option("--guide-where", o.guide_where, "which line of --guide, such as \"name='AB 1'\"");
  Option curved =
      verb.add_option("--curved", o.curved,
                      "curved tracks along edges of the field: auto in those subfields where they cost less "
                      "than straight ones, or always");
  Option tracks = verb.add_option(
      "--tracks", o.tracks,
      "how tracks along a line are made: each parallel to the line and fit to be driven, or as "
      "in the paper on metric maps, each from the one before, kinks and all, to compare with: "
      "parallel or paper (default parallel)");
  tracks.group(lines);
  ab.group(lines).excludes(guide).excludes(curved);
  guide.group(lines).excludes(curved);
  where.group(lines).needs(guide);
  curved.group(lines);
}

}  // namespace

void add_machine_options(Verb& verb, PlanOptions& o, const char* least_length) {
  const char* machine = "Machine";
  verb.add_option("--width", o.width_m, "working width w, m (default 3)").group(machine);
  verb.add_option("--radius", o.radius_m, "least turning radius, m (default 6)").group(machine);
  verb.add_option("--machine", o.machine_file, "machine file (TOML); --width and --radius overrule it")
      .group(machine);
  verb.add_option("--min-length", o.min_length_m,
                  fmt::format("shortest piece worth driving, m (default {})", least_length))
      .group(machine);
}

void add_objective_options(Verb& verb, PlanOptions& o) {
  const char* objective = "Objective";
  Option weights = verb.add_option("--weights", o.weights,
                                   "weights of overlap (1/m²), uncovered (1/m²), turns[, stops[, further\n"
                                   "subfields]]; those left out weigh nothing");
  Option prices = verb.add_option("--prices", o.prices,
                                  "€/m² overlap, €/m² uncovered, €/turn[, €/stop[, €/further subfield]]\n"
                                  "(default 0.02,0.10,1,5,5)");
  Option minimise =
      verb.add_option("--minimise", o.minimise, "overlap, uncovered or turns above all (weight 99999)");
  weights.group(objective).excludes(prices).excludes(minimise);
  prices.group(objective).excludes(minimise);
  minimise.group(objective);
}

void add_plan_options(Verb& verb, PlanOptions& o) {
  add_machine_options(verb, o, "2 w");
  add_objective_options(verb, o);
  const char* plan = "Plan";
  verb.add_option(
          "--strategy", o.strategy,
          "best of all directions, offsets and divisions of the field, or sweep: S1's search over the "
          "directions of the edges (default best)")
      .group(plan);
  verb.add_option("--direction-tolerance", o.direction_tolerance_deg,
                  "with --strategy best: directions nearer than this are one, degrees (default 0.01)")
      .group(plan);
  verb.add_option("--end-rule", o.end_rule,
                  "where swaths end at a soft edge: cheapest, centre, cover or inside (default cheapest)")
      .group(plan);
  verb.add_option("--boundary", o.boundary, "the field's own edge: soft (a headland behind it) or hard")
      .group(plan);
  verb.add_option("--merge", o.merge_deg,
                  "merge subfields whose directions differ by no more, degrees (default 1)")
      .group(plan);
  verb.add_option("--decomposition", o.decomposition_deg,
                  "split at corners with a larger inside angle, degrees (default 180)")
      .group(plan);
  verb.add_option("--short-edge", o.short_edge_m,
                  "do not split at corners between two edges that are both shorter, m (default 0)")
      .group(plan);
  verb.add_option("--cell-direction", o.cell_direction,
                  "a cell's tracks: along its smallest bounding rectangle, or across its least width")
      .group(plan);
  add_obstacle_options(verb, o);
  add_map_options(verb, o);
}

}  // namespace tramline::app
