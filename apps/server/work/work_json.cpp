#include "server/work/work_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>
#include <vector>

#include "report/evaluate_report.h"
#include "report/report_parts.h"
#include "server/http/page_words.h"
#include "tramline/geometry/path/simplified_line.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// Lists of places as text. A replay's first frame may have half a million of them, which as values that are
/// then put into words take ten times as long.
class PlaceText {
 public:
  PlaceText(const ShownPlace& place, double detail_m, std::string& out)
      : place_(place), detail_m_(detail_m), places_(detail_m > 0 ? 8 : 10), out_(out) {}

  void line(const std::vector<Point>& line) {
    if (detail_m_ > 0)
      list(simplified_line(line, detail_m_), [&](std::size_t i) { position(line[i]); });
    else
      list(line, [&](Point p) { position(p); });
  }
  void region(const Region& region) {
    std::vector<std::vector<Ring>> shown;
    for (const Polygon& polygon : region)
      if (std::vector<Ring> rings = rings_of(polygon); !rings.empty()) shown.push_back(std::move(rings));
    list(shown, [&](const std::vector<Ring>& rings) {
      list(rings, [&](const Ring& ring) { list(ring, [&](Point p) { position(p); }); });
    });
  }

 private:
  template <class List, class Item>
  void list(const List& items, Item&& item) {
    char before = '[';
    for (const auto& one : items) {
      out_ += before;
      before = ',';
      item(one);
    }
    out_ += before == '[' ? "[]" : "]";
  }
  void position(Point local_m) {
    const Point p = place_.to_lonlat(local_m);
    out_ += '[';
    degrees(p.x);
    out_ += ',';
    degrees(p.y);
    out_ += ']';
  }
  void degrees(double value) {
    fmt::format_to(std::back_inserter(out_), "{:.{}f}", value, places_);
    while (out_.back() == '0') out_.pop_back();
    if (out_.back() == '.') out_.pop_back();
  }
  /// Closed, the outer one first; none where it is narrower than the eye sees.
  std::vector<Ring> rings_of(const Polygon& polygon) const {
    std::vector<Ring> out;
    if (!add(polygon.outer, out)) return {};
    for (const Ring& hole : polygon.holes) add(hole, out);
    return out;
  }
  bool add(Ring ring, std::vector<Ring>& out) const {
    ring.push_back(ring.front());
    if (detail_m_ > 0) {
      Ring less;
      for (const std::size_t i : simplified_line(ring, detail_m_)) less.push_back(ring[i]);
      ring = std::move(less);
      constexpr std::size_t kTriangle = 4;
      if (ring.size() < kTriangle) return false;
    }
    out.push_back(std::move(ring));
    return true;
  }

  const ShownPlace& place_;
  const double detail_m_;
  const int places_;
  std::string& out_;
};

}  // namespace

std::string tile_id(coverage::TileIndex tile) { return fmt::format("{},{}", tile.column, tile.row); }

ordered_json figures_json(const WorkFigures& figures) {
  const CoverageAreas& areas = figures.areas;
  const auto of_field = [&](double value) {
    return figures.has_field ? app::number_json(value) : ordered_json();
  };
  ordered_json out;
  out["covered_m2"] = areas.covered_m2;
  out["covered_inside_m2"] = of_field(areas.covered_inside_m2);
  out["outside_m2"] = of_field(areas.outside_m2);
  out["repeated_m2"] = areas.repeated_m2;
  out["missed_m2"] = of_field(areas.missed_m2);
  out["not_recorded_m2"] = areas.not_recorded_m2;
  out["gross_m2"] = areas.gross_m2;
  out["sliver_m2"] = areas.sliver_m2;
  if (figures.meshes)
    out["meshes"] =
        app::meshes_json(*figures.meshes, figures.has_field ? app::FieldKnown::kYes : app::FieldKnown::kNo);
  out["worked_s"] = app::number_json(figures.worked_s);
  out["ha_per_hour"] = app::number_json(figures.present_m2_per_s * 3600 / 1e4);
  out["remaining_s"] = app::number_json(remaining_s(figures));
  return out;
}

std::string EventWriter::frame_text(const WorkFrame& frame) {
  if (!place_ || plane_ != frame.plane) {
    plane_ = frame.plane;
    place_.emplace(plane_);
  }
  ordered_json head;
  head["time_s"] = app::number_json(frame.time_s);
  head["fix"] = frame.fix;
  head["fixes"] = frame.fixes;
  head["at"] = frame.at ? place_->position(*frame.at) : ordered_json();
  head["heading_deg"] = frame.heading ? app::number_json(frame.heading->degrees()) : ordered_json();
  head["working"] = frame.working;
  head["quality"] = frame.quality.empty() ? ordered_json() : ordered_json(frame.quality);
  head["figures"] = figures_json(frame.figures);
  head["all"] = frame.changes.all;
  std::string out = app::json_line(head);
  out.back() = ',';  // in the place of its brace
  // Finer than what the outlines are made of there is nothing to be seen but the steps of meshes.
  PlaceText text(*place_, detail_m_ > 0 ? std::max(detail_m_, frame.changes.grain_m) : 0, out);
  out += "\"line\":";
  text.line(frame.line);
  out += ",\"tiles\":[";
  for (const coverage::TileWork& tile : frame.changes.tiles) {
    fmt::format_to(std::back_inserter(out), "{{\"id\":\"{}\",\"covered\":", tile_id(tile.index));
    text.region(tile.covered);
    out += ",\"repeated\":";
    text.region(tile.repeated);
    out += "},";
  }
  if (out.back() == ',') out.pop_back();
  return out += "]}";
}

NamedEvent EventWriter::named(const WorkEvent& event) {
  assert(!std::holds_alternative<std::monostate>(event));
  const auto text = [](const ordered_json& json) { return app::json_line(json); };
  if (const auto* state = std::get_if<FeedState>(&event))
    return {"state", text({{"message", in_page_words(state->message)}, {"connected", state->connected}})};
  if (const auto* end = std::get_if<WorkEnd>(&event))
    return {"end", text({{"figures", figures_json(end->figures)}})};
  return {"frame", frame_text(std::get<WorkFrame>(event))};
}

}  // namespace tramline::server
