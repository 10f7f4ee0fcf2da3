#include "server/work/work_json.h"

#include <fmt/format.h>

#include <cmath>

#include "server/http/page_words.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(); }

ordered_json tiles_json(const std::vector<coverage::TileWork>& tiles, const ShownPlace& place) {
  ordered_json out = ordered_json::array();
  for (const coverage::TileWork& tile : tiles)
    out.push_back({{"id", tile_id(tile.index)},
                   {"covered", place.region(tile.covered)},
                   {"repeated", place.region(tile.repeated)}});
  return out;
}

}  // namespace

std::string tile_id(coverage::TileIndex tile) { return fmt::format("{},{}", tile.column, tile.row); }

ordered_json figures_json(const WorkFigures& figures) {
  const CoverageAreas& areas = figures.areas;
  const auto of_field = [&](double value) { return figures.has_field ? number(value) : ordered_json(); };
  ordered_json out;
  out["covered_m2"] = areas.covered_m2;
  out["covered_inside_m2"] = of_field(areas.covered_inside_m2);
  out["outside_m2"] = of_field(areas.outside_m2);
  out["repeated_m2"] = areas.repeated_m2;
  out["missed_m2"] = of_field(areas.missed_m2);
  out["gross_m2"] = areas.gross_m2;
  out["sliver_m2"] = areas.sliver_m2;
  out["worked_s"] = number(figures.worked_s);
  out["ha_per_hour"] = number(figures.present_m2_per_s * 3600 / 1e4);
  out["remaining_s"] = number(remaining_s(figures));
  return out;
}

ordered_json EventWriter::frame_json(const WorkFrame& frame) {
  if (!place_ || plane_ != frame.plane) {
    plane_ = frame.plane;
    place_.emplace(plane_);
  }
  ordered_json out;
  out["time_s"] = number(frame.time_s);
  out["fix"] = frame.fix;
  out["fixes"] = frame.fixes;
  out["at"] = frame.at ? place_->position(*frame.at) : ordered_json();
  out["heading_deg"] = frame.heading ? number(frame.heading->degrees()) : ordered_json();
  out["working"] = frame.working;
  out["figures"] = figures_json(frame.figures);
  out["line"] = place_->line(frame.line);
  out["all"] = frame.changes.all;
  out["tiles"] = tiles_json(frame.changes.tiles, *place_);
  return out;
}

NamedEvent EventWriter::named(const WorkEvent& event) {
  if (const auto* state = std::get_if<FeedState>(&event))
    return {"state", {{"message", in_page_words(state->message)}, {"connected", state->connected}}};
  if (const auto* end = std::get_if<WorkEnd>(&event))
    return {"end", {{"figures", figures_json(end->figures)}}};
  return {"frame", frame_json(std::get<WorkFrame>(event))};
}

}  // namespace tramline::server
