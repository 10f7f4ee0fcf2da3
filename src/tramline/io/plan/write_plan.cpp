#include "tramline/io/plan/write_plan.h"

#include <ogrsf_frmts.h>

#include <cmath>

#include "tramline/io/field/field_layers.h"
#include "tramline/io/geopackage/layer_styles.h"
#include "tramline/io/geopackage/metadata_table.h"
#include "tramline/io/geopackage/remarks.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/io/geopackage/write_geopackage.h"
#include "tramline/io/plan/detour_text.h"
#include "tramline/io/plan/front_text.h"
#include "tramline/io/plan/path_text.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/plan_rows.h"
#include "tramline/io/plan/plan_styles.h"
#include "tramline/io/plan/route_rows.h"
#include "tramline/io/plan/turn_text.h"

namespace tramline::io {
namespace {

namespace layers = plan_layers;

void write_region(const Target& target, const char* name, const Region& region) {
  Table table(target, name, wkbPolygon, {kAreaColumn});
  for (const Polygon& polygon : region) table.add(target.shapes.polygon(polygon), {area(polygon)});
}

/// direction_rad gives the direction back to the bit, which degrees do not.
void write_subfields(const Target& target, const Plan& plan) {
  Table table(target, layers::kSubfields, wkbPolygon,
              {integer("number"), real("direction_deg"), real("direction_rad"), kAreaColumn});
  long long number = 0;
  for (const Subfield& subfield : plan.subfields)
    table.add(
        target.shapes.polygon(subfield.shape),
        {++number, subfield.direction.degrees(), subfield.direction.angle().radians(), area(subfield.shape)});
}

/// What a GIS draws: two points for a straight piece, chords for one with detours or a curve.
std::vector<Point> drawn(const TrackPiece& piece) {
  if (piece.detours.empty() && piece.curve.empty()) return {piece.start, piece.end};
  return chords(centre_line(piece));
}

long long counted_from_1(std::size_t index) { return static_cast<long long>(index) + 1; }

/// NULL for a path without arcs.
Cell radius_cell(const Path& path) {
  const double smallest_m = smallest_radius(path);
  return std::isfinite(smallest_m) ? Cell(smallest_m) : Cell();
}

/// NULL for a way that cannot be driven.
Cell cost_cell(const WayPast& way) { return way.possible ? Cell(way.cost) : Cell(); }

void write_headland_passes(const Target& target, const Headland& headland) {
  Table table(target, layers::kHeadlandPasses, wkbLineString,
              {integer("number"), flag("around_field"), text("obstacles"), real("length_m"),
               real("smallest_radius_m"), text("path")});
  for (const HeadlandPass& pass : headland.passes) {
    table.add(target.shapes.line(chords(pass.path)),
              {pass.number + 0LL, pass.around_field, obstacles_text(pass.obstacles), length(pass.path),
               radius_cell(pass.path), path_text(pass.path, target.offset)});
  }
}

void write_tracks(const Target& target, const Plan& plan) {
  Table table(
      target, layers::kTracks, wkbLineString,
      {integer("order"), integer("subfield"), integer("track"), text("kind"), real("heading_deg"),
       real("length_m"), real("smallest_radius_m"), text("obstacles"), text("sides"), flag("stop_at_start"),
       flag("stop_at_end"), flag("after_crossing"), text("path"), text("detours")});
  long long order = 0;
  for (const TrackPiece& piece : plan.pieces) {
    const Path path = written_path(piece);
    table.add(target.shapes.line(drawn(piece)),
              {++order, counted_from_1(piece.subfield), piece.track + 1LL, std::string(kind_of(piece)),
               Heading::from_to(piece.start, piece.end).degrees(), length(piece), radius_cell(path),
               obstacles_avoided(piece), sides_text(piece), piece.stop_at_start, piece.stop_at_end,
               piece.after_crossing, path_text(path, target.offset), detours_text(piece)});
  }
}

/// The way of the axle's middle; what a turn without any manoeuvre draws is the hop.
std::vector<Point> drawn(const Plan& plan, const PlannedTurn& turn) {
  const Path path = trace(turn.manoeuvre.path);
  if (!path.empty()) return chords(path);
  return {plan.pieces[turn.after].end, plan.pieces[turn.after + 1].start};
}

void write_turns(const Target& target, const Plan& plan) {
  if (plan.turns.empty()) return;
  Table table(
      target, layers::kTurns, wkbLineString,
      {integer("after"), text("state"), text("kind"), text("word"), integer("gear_changes"), real("length_m"),
       real("time_s"), real("missing_m"), real("lateral_error_m"), text("stretches")});
  for (const PlannedTurn& turn : plan.turns) {
    const SteeredPath& path = turn.manoeuvre.path;
    table.add(
        target.shapes.line(drawn(plan, turn)),
        {counted_from_1(turn.after), std::string(name(turn.state)), std::string(name(turn.manoeuvre.kind)),
         turn.manoeuvre.word, gear_changes(turn.manoeuvre) + 0LL, length(path), turn.time_s, turn.missing_m,
         turn.lateral_error_m, steered_text(path, target.offset)});
  }
}

void write_swaths(const Target& target, const Plan& plan) {
  Table table(target, layers::kSwaths, wkbPolygon,
              {integer("order"), real("width_m"), kAreaColumn, real("overlap_m2")});
  const double width_m = plan.machine.width_m;
  long long order = 0;
  for (const TrackPiece& piece : plan.pieces)
    table.add(target.shapes.polygon({swath(piece, width_m), {}}),
              {++order, width_m, width_m * length(piece), number_if(piece.overlap_m2)});
}

void write_dropped(const Target& target, const Plan& plan) {
  Table table(target, layers::kDropped, wkbLineString, {integer("subfield"), real("length_m"), text("why")});
  for (const DroppedPiece& piece : plan.dropped)
    table.add(target.shapes.line({piece.start, piece.end}),
              {counted_from_1(piece.subfield), distance(piece.start, piece.end), name(piece.why)});
}

void write_encounters(const Target& target, const Plan& plan) {
  Table table(target, layers::kEncounters, wkbPoint,
              {integer("number"), integer("subfield"), integer("track"), text("obstacles"), text("chosen"),
               real("cost_left"), real("cost_right"), text("why_not_left"), text("why_not_right")});
  long long number = 0;
  for (const Encounter& encounter : plan.encounters)
    table.add(
        target.shapes.point(encounter.at),
        {++number, counted_from_1(encounter.subfield), encounter.track + 1LL,
         obstacles_text(encounter.obstacles), std::string(name(encounter.chosen)), cost_cell(encounter.left),
         cost_cell(encounter.right), encounter.left.why_not, encounter.right.why_not});
}

void write_front(const Target& target, const Front& front) {
  if (front.points.empty()) return;
  Table table(
      target, layers::kFront, wkbNone,
      {integer("number"),     real("overlap_m2"),    real("uncovered_m2"),      integer("turns"),
       integer("stops"),      integer("crossings"),  integer("tracks"),         real("track_length_m"),
       real("worked_m2"),     integer("subfields"),  text("direction_deg"),     text("direction_rad"),
       real("cost"),          text("marks"),         real("laid_for_overlap"),  real("laid_for_uncovered"),
       real("laid_for_turn"), real("laid_for_stop"), real("laid_for_subfield"), integer("worked_subfields")});
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const FrontPoint& point = front.points[i];
    const Tally& tally = point.tally;
    const Objective& prices = point.laid_for;
    table.add(nullptr, {static_cast<long long>(i + 1),
                        tally.overlap_m2,
                        tally.uncovered_m2,
                        tally.turns + 0LL,
                        tally.stops + 0LL,
                        tally.crossings + 0LL,
                        tally.pieces + 0LL,
                        tally.track_length_m,
                        tally.worked_m2,
                        static_cast<long long>(point.directions.size()),
                        degrees_text(point.directions),
                        radians_text(point.directions),
                        point.cost,
                        marks_text(front, i),
                        prices.overlap,
                        prices.uncovered,
                        prices.turn,
                        prices.stop,
                        prices.subfield,
                        tally.subfields + 0LL});
  }
}

void write_prices(const Target& target, const GroundPrices& prices) {
  if (prices.cells.empty()) return;
  Table table(target, layers::kPrices, wkbPolygon, {real("price"), kAreaColumn});
  for (const GroundPrices::Cell& cell : prices.cells) {
    const Polygon shape{cell.shape, {}};
    table.add(target.shapes.polygon(shape), {cell.price, area(shape)});
  }
}

Metadata with_remarks(Metadata metadata, const Metadata& remarks) {
  add_remarks(remarks, metadata);
  return metadata;
}

}  // namespace

void write_plan_rows(const Target& target, const Plan& plan, const Metadata& remarks) {
  write_field_layers(target, plan.field);
  write_region(target, layers::kBody, plan.body);
  if (!plan.worked.empty()) write_region(target, layers::kWorked, plan.worked);
  write_region(target, layers::kHeadland, plan.headland.ground);
  write_region(target, layers::kGivenUp, plan.given_up);
  write_subfields(target, plan);
  write_headland_passes(target, plan.headland);
  write_tracks(target, plan);
  write_turns(target, plan);
  write_route_legs(target, plan);
  write_swaths(target, plan);
  write_region(target, layers::kOverlap, plan.overlap);
  write_region(target, layers::kUncovered, plan.uncovered);
  write_region(target, layers::kHeadlandUnworked, plan.headland.unworked);
  write_dropped(target, plan);
  write_encounters(target, plan);
  write_front(target, plan.front);
  write_prices(target, plan.proof.prices);
  write_metadata_table(target, with_remarks(metadata_of(plan), remarks));
}

void write_plan(const Plan& plan, const std::filesystem::path& path, const Metadata& remarks) {
  write_geopackage(path, kPlanFile, plan.field.frame, [&](const Target& target) {
    write_plan_rows(target, plan, remarks);
    write_styles(target.file, styles_of(plan));
  });
}

}  // namespace tramline::io
