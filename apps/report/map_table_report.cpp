#include "report/map_table_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/report_parts.h"
#include "tramline/model/plain_zero.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;
using Kind = MapDirection::Kind;

constexpr const char* kMapRow = "{:<16}{:>7}{:>8}{:>14}{:>13}{:>13}{:>7}{:>10}   {}";

const char* kind_word(Kind kind) {
  switch (kind) {
    case Kind::kGiven:
      return "given";
    case Kind::kEdge:
      return "edge";
    case Kind::kAngle:
      return "angle";
    case Kind::kCurved:
      return "curved";
  }
  return "";
}

bool has_direction(const MapDirection& direction) {
  return direction.kind == Kind::kEdge || direction.kind == Kind::kAngle;
}

std::string map_row(const MapCell& cell) {
  const std::string what = map_direction_text(cell.asked);
  const std::string width = fmt::format("{:g} m", cell.machine.width_m);
  if (!cell.refusal.empty()) return fmt::format("{:<16}{:>7}   {}", what, width, cell.refusal);
  const Tally& tally = cell.tracks;
  return fmt::format(kMapRow, what, width, tally.pieces, fmt::format("{:.1f} m", tally.track_length_m),
                     fmt::format("{:.1f} m²", plain_zero(tally.overlap_m2)),
                     fmt::format("{:.1f} m²", plain_zero(tally.uncovered_m2)), tally.turns,
                     fmt::format("{:.2f}", cell.cost), fmt::format("{:.3f} s", cell.seconds));
}

/// The first of the cells of a width for which `value` is least; nullptr where there is none.
template <class Value>
const MapCell* least_at(const MapTable& table, double width_m, Value value) {
  const MapCell* out = nullptr;
  for (const MapCell& cell : table.cells)
    if (cell.refusal.empty() && cell.machine.width_m == width_m && (!out || value(cell) < value(*out)))
      out = &cell;
  return out;
}

std::string best_rows(const MapTable& table) {
  std::string out;
  if (table.cells.size() <= table.widths_m.size()) return out;  // one direction
  for (const double width_m : table.widths_m) {
    const MapCell* overlap = least_at(table, width_m, [](const MapCell& c) { return c.tracks.overlap_m2; });
    if (!overlap) continue;
    const MapCell* tracks = least_at(table, width_m, [](const MapCell& c) { return c.tracks.pieces; });
    const MapCell* cost = least_at(table, width_m, [](const MapCell& c) { return c.cost; });
    out += fmt::format("at {:g} m       least overlap {}, fewest tracks {}, cheapest {}\n", width_m,
                       map_direction_text(overlap->asked), map_direction_text(tracks->asked),
                       map_direction_text(cost->asked));
  }
  return out.empty() ? out : "\n" + out;
}

ordered_json cell_json(const MapCell& cell) {
  ordered_json out{{"direction", kind_word(cell.asked.kind)}};
  if (has_direction(cell.asked))
    out["direction_deg"] = cell.asked.direction.degrees();
  else
    out["direction_deg"] = nullptr;
  if (cell.asked.kind == Kind::kEdge) out["edge_m"] = cell.asked.edge_m;
  out["width_m"] = cell.machine.width_m;
  if (!cell.refusal.empty()) {
    out["error"] = cell.refusal;
    return out;
  }
  ordered_json directions = ordered_json::array();
  for (const Direction direction : cell.directions) directions.push_back(direction.degrees());
  out["subfield_direction_deg"] = std::move(directions);
  out["tracks"] = cell.tracks.pieces;
  out["track_length_m"] = cell.tracks.track_length_m;
  out["body_m2"] = cell.body_m2;
  out["body_overlap_m2"] = cell.tracks.overlap_m2;
  out["body_uncovered_m2"] = cell.tracks.uncovered_m2;
  out["turns"] = cell.tracks.turns;
  out["cost"] = cell.cost;
  out["seconds"] = cell.seconds;
  return out;
}

}  // namespace

std::string map_direction_text(const MapDirection& direction) {
  switch (direction.kind) {
    case Kind::kGiven:
      return "as given";
    case Kind::kEdge:
      return fmt::format("{:.2f}° edge", direction.direction.degrees());
    case Kind::kAngle:
      return fmt::format("{:g}°", direction.direction.degrees());
    case Kind::kCurved:
      return "curved";
  }
  return "";
}

ordered_json map_table_json(const MapTable& table, const std::vector<Skipped>& skipped) {
  ordered_json cells = ordered_json::array();
  for (const MapCell& cell : table.cells) cells.push_back(cell_json(cell));
  return {{"field_id", table.field.id},      {"area_m2", area_m2(table.field)},
          {"widths_m", table.widths_m},      {"edge_directions_left_out", table.edges_left_out},
          {"maps", std::move(cells)},        {"repairs", repairs_json(table.field.repairs)},
          {"skipped", skipped_json(skipped)}};
}

std::string map_table_text(const MapTable& table, const std::vector<Skipped>& skipped) {
  const std::size_t directions = table.cells.size() / table.widths_m.size();
  std::string out = fmt::format("field        {}, {:.4f} ha without the obstacles\n", table.field.id,
                                area_m2(table.field) / 1e4);
  out += fmt::format(
      "maps         {} direction{} at {} width{}; overlap and uncovered land of the tracks alone\n",
      directions, directions == 1 ? "" : "s", table.widths_m.size(), table.widths_m.size() == 1 ? "" : "s");
  out += skipped_rows(skipped);
  if (table.edges_left_out > 0)
    out += fmt::format("note         {} further direction{} of shorter edges left out\n",
                       table.edges_left_out, table.edges_left_out == 1 ? "" : "s");
  out += "\n";
  out += fmt::format(kMapRow, "direction", "width", "tracks", "length", "overlap", "uncovered", "turns",
                     "cost", "time") +
         "\n";
  const std::size_t widths = table.widths_m.size();
  const bool grouped = directions > 1;
  for (std::size_t width = 0; width < widths; ++width) {
    if (grouped && width > 0) out += "\n";
    for (std::size_t i = width; i < table.cells.size(); i += widths) out += map_row(table.cells[i]) + "\n";
  }
  return out + best_rows(table);
}

std::string map_table_csv(const MapTable& table) {
  std::string out =
      "direction,direction_deg,edge_m,width_m,tracks,track_length_m,body_m2,body_overlap_m2,body_uncovered_"
      "m2,"
      "turns,cost,seconds,error\n";
  for (const MapCell& cell : table.cells) {
    out += fmt::format(
        "{},{},{},{},", kind_word(cell.asked.kind),
        has_direction(cell.asked) ? fmt::format("{:.10g}", cell.asked.direction.degrees()) : std::string(),
        cell.asked.kind == Kind::kEdge ? fmt::format("{}", cell.asked.edge_m) : std::string(),
        cell.machine.width_m);
    if (!cell.refusal.empty()) {
      out += ",,,,,,,," + csv_text(cell.refusal) + "\n";
      continue;
    }
    const Tally& tally = cell.tracks;
    out += fmt::format("{},{},{},{},{},{},{},{},\n", tally.pieces, tally.track_length_m, cell.body_m2,
                       plain_zero(tally.overlap_m2), plain_zero(tally.uncovered_m2), tally.turns, cell.cost,
                       cell.seconds);
  }
  return out;
}

}  // namespace tramline::app
