#include "tramline/render/page/legend.h"

#include <numbers>

#include "tramline/render/page/map_symbols.h"
#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr double kLegendHeadingHeight = 34;
constexpr double kLegendRowHeight = 27;
constexpr double kBlockGap = 20;
constexpr double kSwatchWidth = 34;
constexpr double kSwatchHeight = 18;
constexpr double kTextIndent = 46;

void draw_swatch_box(Canvas& canvas, const Box& box, Colour ground, const Hatch* style, Colour edge) {
  const double k = canvas.scale();
  fill_box(canvas, box, ground);
  if (style != nullptr) hatch_box(canvas, box, *style);
  stroke_line(canvas,
              {{box.min_x, box.min_y},
               {box.max_x, box.min_y},
               {box.max_x, box.max_y},
               {box.min_x, box.max_y},
               {box.min_x, box.min_y}},
              {edge, 1.3 * k});
}

// A sidestep, so that the row is known by its shape too.
void draw_detour_swatch(Canvas& canvas, const Box& box) {
  const double k = canvas.scale();
  const double low = box.centre().y + 4 * k, high = box.centre().y - 4 * k;
  const double x = box.min_x, step = 0.2 * box.width();
  const std::vector<Point> bump{{x, low},
                                {x + step, low},
                                {x + 1.8 * step, high},
                                {x + 3.2 * step, high},
                                {x + 4 * step, low},
                                {x + 5 * step, low}};
  stroke_line(canvas, bump, {kDetourColour, kDetourLine * k});
}

void draw_arc_swatch(Canvas& canvas, const Box& box) {
  const double k = canvas.scale();
  const double r = 0.5 * box.height();
  const Point hub = box.centre();
  cairo_new_path(canvas.cr());
  cairo_arc(canvas.cr(), hub.x, hub.y, r, 0, 2 * std::numbers::pi);
  set_stroke(canvas, {kRadiusColour, kRadiusLine * k, {3 * k, 3 * k}});
  cairo_stroke(canvas.cr());
  stroke_line(canvas, {hub, hub + Point{0, -r}}, {kRadiusColour, kRadiusLine * k});
  disc(canvas, hub, 2.5 * k, kDetourColour);
}

void draw_swatch_line(Canvas& canvas, const Box& box, const LegendRow& row) {
  const double k = canvas.scale();
  const Point left{box.min_x, box.centre().y};
  const Point right{box.max_x, box.centre().y};
  if (row.symbol == Symbol::kTrack) {
    stroke_line(canvas, {left, right}, {kTrackColour, kTrackLine * k});
    draw_arrow_head(canvas, box.centre() + Point{5 * k, 0}, {1, 0}, 10 * k, kFieldEdge);
  } else if (row.symbol == Symbol::kDetour) {
    draw_detour_swatch(canvas, box);
  } else if (row.symbol == Symbol::kTurn) {
    stroke_line(canvas, {left, right}, {kTurnColour, kTurnLine * k});
  } else if (row.symbol == Symbol::kTurnInReverse) {
    stroke_line(canvas, {left, right}, {kTurnColour, kTurnLine * k, {3 * k, 3 * k}});
  } else if (row.symbol == Symbol::kNoRoom) {
    stroke_line(canvas, {left, right}, {kNoRoomColour, kTurnLine * k});
  } else if (row.symbol == Symbol::kTransit) {
    stroke_line(canvas, {left, right}, {kTransitColour, kTurnLine * k});
  } else if (row.symbol == Symbol::kBackOut) {
    stroke_line(canvas, {left, right}, {kBackOutColour, kTurnLine * k, {3 * k, 3 * k}});
  } else if (row.symbol == Symbol::kRouteStart) {
    draw_route_mark(canvas, box.centre(), kRouteStartColour);
  } else if (row.symbol == Symbol::kRouteEnd) {
    draw_route_mark(canvas, box.centre(), kRouteEndColour);
  } else if (row.symbol == Symbol::kHeadlandPass) {
    stroke_line(canvas, {left, right},
                {kHeadlandPassColour, kHeadlandLine * k, {kHeadlandDash * k, 0.5 * kHeadlandDash * k}});
    draw_arrow_head(canvas, box.centre() + Point{5 * k, 0}, {1, 0}, 10 * k, kHeadlandPassColour);
  } else if (row.symbol == Symbol::kReference) {
    stroke_line(canvas, {left, right}, {kReferenceColour, kReferenceLine * k, reference_dashes(k)});
  } else if (row.symbol == Symbol::kTightestArc) {
    draw_arc_swatch(canvas, box);
  } else if (row.symbol == Symbol::kKeepOff) {
    stroke_line(canvas, {left, right},
                {kKeepOffColour, kKeepOffLine * k, {kKeepOffDash * k, 0.6 * kKeepOffDash * k}});
  } else if (row.symbol == Symbol::kDropped) {
    stroke_line(canvas, {left, right}, {kDroppedColour, kDroppedLine * k, {5 * k, 3 * k}});
  } else if (row.symbol == Symbol::kWorkedPath) {
    stroke_line(canvas, {left, right}, {kWorkedPathColour, kPathLine * k});
  } else if (row.symbol == Symbol::kIdlePath) {
    stroke_line(canvas, {left, right}, {kIdlePathColour, kPathLine * k, idle_dashes(k)});
  } else if (row.symbol == Symbol::kStop) {
    stroke_line(canvas, {left, box.centre()}, {kTrackColour, kTrackLine * k});
    draw_stop_mark(canvas, box.centre(), kStopRadius * k);
  }
}

void draw_symbol(Canvas& canvas, const Box& box, const LegendRow& row) {
  switch (row.symbol) {
    case Symbol::kNone:
      return;
    case Symbol::kField:
      return draw_swatch_box(canvas, box, kFieldColour, nullptr, kFieldEdge);
    case Symbol::kObstacle:
      return draw_swatch_box(canvas, box, kObstacleColour, &obstacle_hatch(), kObstacleColour);
    case Symbol::kPassable:
      return draw_swatch_box(canvas, box, kPassableColour, &passable_hatch(), kPassableHatch);
    case Symbol::kGivenUp:
      return draw_swatch_box(canvas, box, kUncoveredColour, &given_up_hatch(), kUncoveredColour);
    case Symbol::kHeadland:
      return draw_swatch_box(canvas, box, kHeadlandColour, nullptr, kSubfieldEdge);
    case Symbol::kSwathEdge:
      return draw_swatch_box(canvas, box, kWorkedLandColour, nullptr, kSwathEdgeColour);
    case Symbol::kOverlap:
      return draw_swatch_box(canvas, box, kOverlapColour, nullptr, kOverlapColour);
    case Symbol::kUncovered:
      return draw_swatch_box(canvas, box, kUncoveredColour, nullptr, kUncoveredColour);
    case Symbol::kNotRecorded:
      return draw_swatch_box(canvas, box, kNotRecordedColour, &not_recorded_hatch(), kNotRecordedColour);
    case Symbol::kCovered:
      return draw_swatch_box(canvas, box, kCoveredColour, nullptr, kCoveredEdge);
    case Symbol::kCoveredOutside:
      return draw_swatch_box(canvas, box, kCoveredOutsideColour, nullptr, kCoveredEdge);
    case Symbol::kGap:
      return draw_gap_badge(canvas, box.centre(), row.index + 1);
    case Symbol::kSubfield: {
      draw_swatch_box(canvas, box, tint(static_cast<std::size_t>(row.index)), nullptr, kSubfieldEdge);
      const std::string number = std::to_string(row.index + 1);
      return draw_text(canvas, box.centre(), number, {kSmallTextSize, true, Align::kCentre});
    }
    case Symbol::kTrack:
    case Symbol::kDetour:
    case Symbol::kTurn:
    case Symbol::kTurnInReverse:
    case Symbol::kNoRoom:
    case Symbol::kTransit:
    case Symbol::kBackOut:
    case Symbol::kRouteStart:
    case Symbol::kRouteEnd:
    case Symbol::kHeadlandPass:
    case Symbol::kReference:
    case Symbol::kTightestArc:
    case Symbol::kKeepOff:
    case Symbol::kDropped:
    case Symbol::kStop:
    case Symbol::kWorkedPath:
    case Symbol::kIdlePath:
      return draw_swatch_line(canvas, box, row);
  }
}

void draw_row(Canvas& canvas, const Box& box, const LegendRow& row) {
  const double k = canvas.scale();
  const double middle = box.centre().y;
  const bool has_symbol = row.symbol != Symbol::kNone;
  const double half = 0.5 * kSwatchHeight * k;
  if (has_symbol)
    draw_symbol(canvas, {box.min_x, middle - half, box.min_x + kSwatchWidth * k, middle + half}, row);
  const double indent = has_symbol ? kTextIndent * k : 0;
  const double value_width = text_width(canvas, row.value, {});
  const double room = box.width() - indent - value_width - 8 * k;
  draw_text(canvas, {box.min_x + indent, middle}, fitted(canvas, row.text, {}, room), {});
  draw_text(canvas, {box.max_x, middle}, row.value, {kTextSize, false, Align::kRight});
}

double height_of(const LegendBlock& block) {
  return kLegendHeadingHeight + kLegendRowHeight * static_cast<double>(block.rows.size()) + kBlockGap;
}

void draw_block(Canvas& canvas, Point corner, double width, const LegendBlock& block) {
  const double k = canvas.scale();
  draw_text(canvas, {corner.x, corner.y + 10 * k}, block.heading, {kTextSize, true, Align::kLeft, kInk});
  const double rule = corner.y + 26 * k;
  stroke_line(canvas, {{corner.x, rule}, {corner.x + width, rule}}, {kRule, 1.2 * k});
  double top = corner.y + kLegendHeadingHeight * k;
  for (const LegendRow& row : block.rows) {
    draw_row(canvas, {corner.x, top, corner.x + width, top + kLegendRowHeight * k}, row);
    top += kLegendRowHeight * k;
  }
}

}  // namespace

std::vector<double> heights_of(const std::vector<LegendBlock>& blocks) {
  std::vector<double> out;
  for (const LegendBlock& block : blocks) out.push_back(height_of(block));
  return out;
}

std::vector<Box> rows_of_blocks(const PageLayout& page, const std::vector<LegendBlock>& blocks) {
  const double k = page.text_scale;
  const double gap = 36 * k;
  const double width = (page.panel.width() - gap * (page.panel_columns - 1)) / page.panel_columns;
  const std::vector<double> heights = heights_of(blocks);
  const std::vector<int> column = columns_of_blocks(heights, page.panel_columns);
  std::vector<double> top(static_cast<std::size_t>(page.panel_columns), page.panel.min_y);
  std::vector<Box> out;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    double& y = top[static_cast<std::size_t>(column[i])];
    const double left = page.panel.min_x + column[i] * (width + gap);
    out.push_back({left, y + kLegendHeadingHeight * k, left + width, y + (heights[i] - kBlockGap) * k});
    y += heights[i] * k;
  }
  return out;
}

void draw_legend(Canvas& canvas, const PageLayout& page, const std::vector<LegendBlock>& blocks) {
  const std::vector<Box> rows = rows_of_blocks(page, blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    draw_block(canvas, {rows[i].min_x, rows[i].min_y - kLegendHeadingHeight * canvas.scale()},
               rows[i].width(), blocks[i]);
}

}  // namespace tramline::render
