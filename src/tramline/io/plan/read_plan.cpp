#include "tramline/io/plan/read_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/field/field_layers.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/metadata_table.h"
#include "tramline/io/geopackage/remarks.h"
#include "tramline/io/geopackage/rows.h"
#include "tramline/io/plan/common_frame.h"
#include "tramline/io/plan/derived_values.h"
#include "tramline/io/plan/detour_text.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/front_text.h"
#include "tramline/io/plan/path_text.h"
#include "tramline/io/plan/plan_collection.h"
#include "tramline/io/plan/plan_layers.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/route_rows.h"
#include "tramline/io/plan/turn_text.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;
namespace layers = plan_layers;

/// A file of many plans keeps corners in another plane than the one areas were measured in.
void derive_area(PlanFile& out, const Row& row, const Polygon& polygon) {
  constexpr double kCornerRounding_m = 1e-7;
  derive(out, row, "area_m2", area(polygon), polygon.outer.front());
  double edges_m = perimeter(polygon.outer);
  for (const Ring& hole : polygon.holes) edges_m += perimeter(hole);
  out.derived.back().rounding = kCornerRounding_m * edges_m;
}

void read_region(Rows& file, const char* name, Region& into, PlanFile& out) {
  file.each(name, [&](const Row& row) {
    into.push_back(row.polygon());
    derive_area(out, row, into.back());
  });
}

void read_subfields(Rows& file, PlanFile& out) {
  file.each(layers::kSubfields, [&](const Row& row) {
    const Angle angle = Angle::radians(row.number("direction_rad"));
    out.plan.subfields.push_back({row.polygon(), Direction::clockwise_from_north(angle)});
    const Subfield& subfield = out.plan.subfields.back();
    derive_area(out, row, subfield.shape);
    derive(out, row, "direction_deg", subfield.direction.degrees(), subfield.shape.outer.front());
    derive(out, row, "number", static_cast<double>(out.plan.subfields.size()), subfield.shape.outer.front());
  });
}

/// Rows of a layer sorted by their column order.
template <class Item>
void sort_into(std::vector<std::pair<int, Item>>& rows, std::vector<int>& order, std::vector<Item>& items) {
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [number, item] : rows) {
    order.push_back(number);
    items.push_back(std::move(item));
  }
}

void derive_text(PlanFile& out, const Row& row, const char* column, std::string from_shape, Point at) {
  out.derived_texts.push_back({place_in_file(row, column), row.text(column), std::move(from_shape), at});
}

/// A path without arcs has no smallest radius: NULL in the file, 0 here.
void derive_smallest_radius(PlanFile& out, const Row& row, const Path& path) {
  const double smallest_m = smallest_radius(path);
  out.derived.push_back({place_in_file(row, "smallest_radius_m"),
                         row.number_if_any("smallest_radius_m").value_or(0),
                         std::isfinite(smallest_m) ? smallest_m : 0, path.front().from});
}

/// All that a row says about a piece beside its path: numbers and words for people.
void derive_of_piece(PlanFile& out, const Row& row, const TrackPiece& piece) {
  derive(out, row, "length_m", length(piece), piece.start);
  derive(out, row, "heading_deg", Heading::from_to(piece.start, piece.end).degrees(), piece.start);
  derive_smallest_radius(out, row, written_path(piece));
  derive_text(out, row, "kind", kind_of(piece), piece.start);
  derive_text(out, row, "obstacles", obstacles_avoided(piece), piece.start);
  derive_text(out, row, "sides", sides_text(piece), piece.start);
}

/// A straight line may be a piece of a curved family, so the word `curved` decides; the other two follow from
/// the detours.
TrackPiece piece_of(const Row& row, const Path& path) {
  const bool curved = row.text("kind") == layers::kCurved;
  return (curved ? curved_piece : piece_from_text)(path, row.text("detours"), row.place_of("detours"));
}

void read_headland_passes(Rows& file, PlanFile& out) {
  file.each(layers::kHeadlandPasses, [&](const Row& row) {
    out.headland_lines.push_back(row.line());
    HeadlandPass pass;
    pass.path = path_from_text(row.text("path"), row.offset(), row.place_of("path"));
    pass.number = row.whole("number");
    pass.around_field = row.flag("around_field");
    pass.obstacles = obstacles_from_text(row.text("obstacles"), row.place_of("obstacles"));
    derive(out, row, "length_m", length(pass.path), pass.path.front().from);
    derive_smallest_radius(out, row, pass.path);
    out.plan.headland.passes.push_back(std::move(pass));
  });
}

void read_headland(Rows& file, PlanFile& out) {
  read_region(file, layers::kHeadland, out.plan.headland.ground, out);
  read_headland_passes(file, out);
  read_region(file, layers::kHeadlandUnworked, out.plan.headland.unworked, out);
}

/// Files count from 1. Lesser numbers become indices beyond all others, which check finds as it finds those
/// that are too large.
std::size_t subfield_of(const Row& row) { return static_cast<std::size_t>(row.whole("subfield")) - 1; }

void read_tracks(Rows& file, PlanFile& out) {
  using Track = std::pair<TrackPiece, std::vector<Point>>;
  std::vector<std::pair<int, Track>> rows;
  file.each(layers::kTracks, [&](const Row& row) {
    std::vector<Point> line = row.line();
    const Path path = path_from_text(row.text("path"), row.offset(), row.place_of("path"));
    TrackPiece piece = piece_of(row, path);
    piece.subfield = subfield_of(row);
    piece.track = row.whole("track") - 1;
    piece.stop_at_start = row.flag("stop_at_start");
    piece.stop_at_end = row.flag("stop_at_end");
    piece.after_crossing = row.flag("after_crossing");
    derive_of_piece(out, row, piece);
    rows.push_back({row.whole("order"), {std::move(piece), std::move(line)}});
  });
  std::vector<Track> tracks;
  sort_into(rows, out.track_order, tracks);
  for (auto& [piece, line] : tracks) {
    out.plan.pieces.push_back(std::move(piece));
    out.track_lines.push_back(std::move(line));
  }
}

/// Only plans that were asked for turns have the layer.
void read_turns(Rows& file, PlanFile& out) {
  if (!file.has(layers::kTurns)) return;
  const auto word = [](const Row& row, const char* column, auto choice) {
    if (!choice)
      throw bad_input(fmt::format("{} is '{}', a word that this version of tramline does not know",
                                  row.place_of(column), row.text(column)));
    return *choice;
  };
  file.each(layers::kTurns, [&](const Row& row) {
    PlannedTurn turn;
    turn.after = static_cast<std::size_t>(row.whole("after")) - 1;
    turn.state = word(row, "state", turn_state_named(row.text("state")));
    turn.manoeuvre.kind = word(row, "kind", manoeuvre_kind_named(row.text("kind")));
    turn.manoeuvre.word = row.text("word");
    turn.manoeuvre.path = steered_from_text(row.text("stretches"), row.offset(), row.place_of("stretches"));
    turn.time_s = row.number("time_s");
    turn.missing_m = row.number("missing_m");
    turn.lateral_error_m = row.number("lateral_error_m");
    const Point at = row.line().front();
    derive(out, row, "length_m", length(turn.manoeuvre.path), at);
    derive(out, row, "gear_changes", gear_changes(turn.manoeuvre), at);
    out.plan.turns.push_back(std::move(turn));
  });
}

/// The index of the piece of this order number; nullopt where there is none.
std::optional<std::size_t> piece_numbered(const PlanFile& file, int order) {
  const auto& orders = file.track_order;
  const auto found = std::lower_bound(orders.begin(), orders.end(), order);
  if (found == orders.end() || *found != order) return std::nullopt;
  return static_cast<std::size_t>(found - orders.begin());
}

/// What the swath of this order number measures: width · length of the track of that number, for
/// chords fall short of arcs; by its own shape where there is no such track.
double swath_area(const PlanFile& file, int order, const Polygon& swath) {
  const std::optional<std::size_t> piece = piece_numbered(file, order);
  return piece ? file.plan.machine.width_m * length(file.plan.pieces[*piece]) : area(swath);
}

/// Files from before this was said lack the column.
void read_swaths(Rows& file, PlanFile& out) {
  std::vector<std::pair<int, Polygon>> rows;
  file.each(layers::kSwaths, [&](const Row& row) {
    rows.emplace_back(row.whole("order"), row.polygon());
    const auto& [order, swath] = rows.back();
    derive(out, row, "area_m2", swath_area(out, order, swath), swath.outer.front());
    derive(out, row, "width_m", out.plan.machine.width_m, swath.outer.front());
    if (const std::optional<std::size_t> piece = piece_numbered(out, order); piece && row.has("overlap_m2"))
      out.plan.pieces[*piece].overlap_m2 = row.number_if_any("overlap_m2");
  });
  sort_into(rows, out.swath_order, out.swaths);
}

/// Older files have pieces that are too short alone.
DroppedFor read_why_dropped(const Row& row) {
  if (!row.has("why")) return DroppedFor::kShort;
  const std::string why = row.text("why");
  const std::optional<DroppedFor> out = dropped_for_named(why);
  if (!out) throw bad_input(fmt::format("{} is '{}', expected short or way", row.place_of("why"), why));
  return *out;
}

void read_dropped(Rows& file, PlanFile& out) {
  file.each(layers::kDropped, [&](const Row& row) {
    const auto [start, end] = row.straight_line();
    out.plan.dropped.push_back({start, end, subfield_of(row), read_why_dropped(row)});
    derive(out, row, "length_m", distance(start, end), start);
  });
}

/// A way has a cost where it is possible and a reason where it is not.
WayPast read_way(const Row& row, const char* cost, const char* why_not) {
  const std::optional<double> number = row.number_if_any(cost);
  return {number.has_value(), number.value_or(0), row.text(why_not)};
}

void read_encounters(Rows& file, PlanFile& out) {
  file.each(layers::kEncounters, [&](const Row& row) {
    Encounter encounter;
    encounter.at = row.point();
    encounter.subfield = subfield_of(row);
    encounter.track = row.whole("track") - 1;
    encounter.obstacles = obstacles_from_text(row.text("obstacles"), row.place_of("obstacles"));
    const std::string chosen = row.text("chosen");
    const std::optional<Passing> way = passing_named(chosen);
    if (!way)
      throw bad_input(fmt::format("{} is '{}', expected left, right or cut", row.place_of("chosen"), chosen));
    encounter.chosen = *way;
    encounter.left = read_way(row, "cost_left", "why_not_left");
    encounter.right = read_way(row, "cost_right", "why_not_right");
    out.plan.encounters.push_back(std::move(encounter));
    derive(out, row, "number", static_cast<double>(out.plan.encounters.size()),
           out.plan.encounters.back().at);
  });
}

/// Only plans that were asked for a front have the table.
void read_front(Rows& file, PlanFile& out) {
  if (!file.has(layers::kFront)) return;
  Front& front = out.plan.front;
  front.prices = out.plan.objective;
  std::vector<DerivedText> marks;  // they are complete when all rows are read
  file.each(layers::kFront, [&](const Row& row) {
    FrontPoint point;
    Tally& tally = point.tally;
    tally.overlap_m2 = row.number("overlap_m2");
    tally.uncovered_m2 = row.number("uncovered_m2");
    tally.turns = row.whole("turns");
    tally.stops = row.whole("stops");
    tally.crossings = row.whole("crossings");
    tally.pieces = row.whole("tracks");
    tally.track_length_m = row.number("track_length_m");
    tally.worked_m2 = row.number("worked_m2");
    point.directions = directions_from_text(row.text("direction_rad"), row.place_of("direction_rad"));
    point.cost = row.number("cost");
    point.laid_for = {row.number("laid_for_overlap"), row.number("laid_for_uncovered"),
                      row.number("laid_for_turn"), row.number("laid_for_stop"), 0};
    if (out.plan.figures == PlanFigures::kTracksAndPasses) {
      point.laid_for.subfield = row.number("laid_for_subfield");
      tally.subfields = row.whole("worked_subfields");
    }
    apply_marks(row.text("marks"), front.points.size(), row.place_of("marks"), front.marks);
    front.points.push_back(std::move(point));
    const FrontPoint& read = front.points.back();
    const Point at = out.plan.field.outer.front();
    derive(out, row, "number", static_cast<double>(front.points.size()), at);
    derive(out, row, "subfields", static_cast<double>(read.directions.size()), at);
    derive(out, row, "cost", cost(front.prices, read.tally), at);
    // What headland passes work is the same in all plans of a field.
    const double passes_m2 = out.plan.tally.worked_m2 - out.plan.track_tally.worked_m2;
    derive(out, row, "worked_m2", out.plan.machine.width_m * read.tally.track_length_m + passes_m2, at);
    derive_text(out, row, "direction_deg", degrees_text(read.directions), at);
    marks.push_back({place_in_file(row, "marks"), row.text("marks"), "", at});
  });
  for (std::size_t i = 0; i < marks.size(); ++i) {
    marks[i].from_shape = marks_text(front, i);
    out.derived_texts.push_back(std::move(marks[i]));
  }
}

/// Only plans that were asked for a proof by prices of the land have the layer.
void read_prices(Rows& file, PlanFile& out) {
  if (!file.has(layers::kPrices)) return;
  file.each(layers::kPrices, [&](const Row& row) {
    const Polygon shape = row.polygon();
    out.plan.proof.prices.cells.push_back({shape.outer, row.number("price")});
    derive_area(out, row, shape);
  });
}

/// What the table says for people and no reader needs, or in other units.
void derive_of_metadata(PlanFile& out, const Metadata& metadata) {
  for (const auto& [key, value] : metadata_of(out.plan)) {
    const bool repeats =
        key == "kind" || key.starts_with("edges.") || (key.starts_with("settings.") && key.ends_with("_deg"));
    const auto stored = metadata.find(key);
    if (repeats && stored != metadata.end())
      out.derived_texts.push_back(
          {"table metadata, " + key, stored->second, value, out.plan.field.outer.front()});
  }
}

}  // namespace

PlanFile read_plan_file(const fs::path& path, const std::string& field) {
  GdalErrors errors;
  Rows file(path, kPlanFile, errors);
  const std::optional<LocalFrame> common = collection_frame(file, path);
  if (common) file.only(chosen_field(fields_in(path), field, path).key);
  PlanFile out;
  const Metadata metadata = read_metadata_table(file);
  out.remarks = remarks_in(metadata);
  const int version = apply_metadata(metadata, path, out.plan);
  if (!common && !field.empty() && field != out.plan.field.id)
    throw bad_input(
        fmt::format("{}: this is the plan of field {}, not of {}", path.string(), out.plan.field.id, field));
  file.shift_by(offset_of(out.plan.field.frame));
  if (common && common->geodetic) file.project_by(way_between(*common, out.plan.field.frame));

  read_field_layers(file, path, kPlanFile, out.plan.field,
                    [&](const Row& row, const Polygon& polygon) { derive_area(out, row, polygon); });
  read_region(file, layers::kBody, out.plan.body, out);
  if (version == kVersionWithRepairs || file.has(layers::kWorked))
    read_region(file, layers::kWorked, out.plan.worked, out);
  // By its layers, not by its word: the word is compared with them. Only repairs had worked land before.
  if (!out.plan.worked.empty() && version < kVersionWithGivenLand) out.plan.kind = PlanKind::kRepair;
  if (version >= kVersionWithHeadlands) read_headland(file, out);
  read_region(file, layers::kGivenUp, out.plan.given_up, out);
  read_subfields(file, out);
  apply_references(metadata, path, version, out.plan);
  apply_given_land(metadata, path, out.plan);
  read_tracks(file, out);
  read_turns(file, out);
  read_route_legs(file, out);
  read_swaths(file, out);
  read_region(file, layers::kOverlap, out.plan.overlap, out);
  read_region(file, layers::kUncovered, out.plan.uncovered, out);
  read_dropped(file, out);
  read_encounters(file, out);
  read_front(file, out);
  read_prices(file, out);
  if (out.plan.route.planned()) out.stated_cost = stated_cost_in(metadata, path);
  derive_of_metadata(out, metadata);
  return out;
}

Plan read_plan(const fs::path& path, const std::string& field) { return read_plan_file(path, field).plan; }

}  // namespace tramline::io
