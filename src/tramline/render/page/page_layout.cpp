#include "tramline/render/page/page_layout.h"

#include <algorithm>
#include <cmath>

namespace tramline::render {
namespace {

constexpr double kMargin = 28;
constexpr double kTitleHeight = 62;
constexpr double kStripHeight = 64;
constexpr double kPanelWidth = 372;
constexpr double kColumnWidth = 372;
// Room for the numbers of tracks that start on the field's edge.
constexpr double kMapPadding = 46;
// Fields wider than this, in terms of their height, get their legend below.
constexpr double kWideField = 1.9;
constexpr double kLeastMapHeight = 320;
constexpr double kTallestMap = 1.3;  // of the map's width

double column_height(const std::vector<double>& heights, int columns) {
  std::vector<double> sums(static_cast<std::size_t>(columns), 0.0);
  const std::vector<int> column = columns_of_blocks(heights, columns);
  for (std::size_t i = 0; i < heights.size(); ++i) sums[static_cast<std::size_t>(column[i])] += heights[i];
  return *std::max_element(sums.begin(), sums.end());
}

MapView fit(const Box& drawn_m, const Box& map, double padding) {
  const double room_x = map.width() - 2 * padding;
  const double room_y = map.height() - 2 * padding;
  // A centimetre at least, so that a degenerate box still has a scale.
  const double wide = std::max(drawn_m.width(), 0.01);
  const double high = std::max(drawn_m.height(), 0.01);
  return {drawn_m.centre(), map.centre(), std::min(room_x / wide, room_y / high)};
}

}  // namespace

std::vector<int> columns_of_blocks(const std::vector<double>& block_heights, int columns) {
  std::vector<double> filled(static_cast<std::size_t>(columns), 0.0);
  std::vector<int> out;
  for (const double height : block_heights) {
    const auto shortest = std::min_element(filled.begin(), filled.end());
    *shortest += height;
    out.push_back(static_cast<int>(shortest - filled.begin()));
  }
  return out;
}

PageLayout lay_out_page(const Box& drawn_m, int width_px, const std::vector<double>& block_heights) {
  PageLayout page;
  page.width_px = width_px;
  page.text_scale = std::max(1.0, width_px / 1600.0);
  const double k = page.text_scale;
  const double margin = kMargin * k;
  const double inner = width_px - 2 * margin;
  const double shape = std::max(drawn_m.height(), 0.01) / std::max(drawn_m.width(), 0.01);
  const bool beside = shape > 1 / kWideField && inner > 3 * kPanelWidth * k;

  const auto blocks = static_cast<int>(block_heights.size());
  page.panel_columns =
      beside ? 1 : std::clamp(static_cast<int>(inner / (kColumnWidth * k)), 1, std::max(1, blocks));
  const double panel_height = column_height(block_heights, page.panel_columns) * k;
  const double map_width = beside ? inner - (kPanelWidth + kMargin) * k : inner;
  const double padding = kMapPadding * k;
  double map_height = shape * (map_width - 2 * padding) + 2 * padding;
  const double least =
      beside ? std::max(kLeastMapHeight * k, panel_height - kStripHeight * k) : kLeastMapHeight * k;
  map_height = std::clamp(map_height, least, std::max(least, kTallestMap * map_width));

  const double top = margin + kTitleHeight * k;
  const double left = margin;
  page.title = {left, margin, left + inner, top};
  page.map = {left, top, left + map_width, top + map_height};
  page.scale_strip = {left, page.map.max_y, page.map.max_x, page.map.max_y + kStripHeight * k};
  if (beside) {
    page.panel = {page.map.max_x + margin, top, left + inner, page.scale_strip.max_y};
  } else {
    const double panel_top = page.scale_strip.max_y + 0.5 * margin;
    page.panel = {left, panel_top, left + inner, panel_top + panel_height};
  }
  page.height_px = static_cast<int>(std::ceil(std::max(page.panel.max_y, page.scale_strip.max_y) + margin));
  page.view = fit(drawn_m, page.map, padding);
  return page;
}

Box drawn_box(const Plan& plan) {
  constexpr double kSagitta = 0.01;  // no page shows a centimetre less of a field
  const double width_m = plan.machine.width_m;
  Box box = bounds(plan.field.outer);
  box.extend(bounds(plan.body));
  for (const TrackPiece& piece : plan.pieces)
    if (!(piece.start == piece.end)) box.extend(bounds(band(centre_line(piece), width_m, kSagitta)));
  for (const PlannedTurn& turn : plan.turns)
    if (turn.state != TurnState::kApart && length(turn.manoeuvre.path) > 0)
      for (const Point p : chords(trace(turn.manoeuvre.path, kSagitta), kSagitta)) box.extend(p);
  for (const RouteLeg& leg : plan.route.legs)
    if (length(leg) > 0)
      for (const Point p : chords(trace(leg.path, kSagitta), kSagitta)) box.extend(p);
  for (const DroppedPiece& piece : plan.dropped) {
    box.extend(piece.start);
    box.extend(piece.end);
  }
  return box;
}

}  // namespace tramline::render
