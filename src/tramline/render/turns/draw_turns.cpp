#include "tramline/render/turns/draw_turns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/render/page/map_decorations.h"
#include "tramline/render/page/map_symbols.h"
#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr int kPageWidth_px = 1600;
constexpr double kPageMargin = 28;
constexpr double kPageTitle = 62;
constexpr double kBetween = 28;
constexpr double kCellCaption = 52;
constexpr double kScaleStrip = 44;
constexpr std::size_t kMostAcross = 4;
/// Of a cell above its width: what is higher is drawn smaller.
constexpr double kMostHeight = 1.4;

constexpr Colour kLandColour = rgb(0xF3EFE2);
constexpr Colour kSweptColour = rgb(0xF6C667);
constexpr Colour kPassColour = rgb(0xBBAE8C);
constexpr Colour kForwardColour = rgb(0x1F4E8C);
constexpr Colour kReverseColour = rgb(0xC0392B);

Point outward_of(const DrawnTurn& turn) { return left_of(turn.border); }

/// How far below the border tracks are drawn, m.
double shown_below_m(const DrawnTurn& turn) { return 2 * turn.width_m; }

void extend(Box& box, Point p) {
  box = {std::min(box.min_x, p.x), std::min(box.min_y, p.y), std::max(box.max_x, p.x),
         std::max(box.max_y, p.y)};
}

/// All that is drawn of a turn: the land swept, both tracks, and the passes over them.
Box box_of(const DrawnTurn& turn) {
  const Point far_end = turn.spacing_m / turn.border.x * turn.border;
  const double half_m = turn.width_m / 2;
  Box out{-half_m, std::min(0.0, far_end.y) - shown_below_m(turn), turn.spacing_m + half_m,
          std::max(0.0, far_end.y)};
  for (const Polygon& polygon : turn.swept)
    for (const Point p : polygon.outer) extend(out, p);
  for (const Point p : {Point{0, 0}, far_end}) extend(out, p + turn.depth_m * outward_of(turn));
  return out;
}

struct Grid {
  std::size_t across = 1;
  double cell_width = 0, map_height = 0, top = 0;
  double px_per_m = 1;
  int height_px = 0;

  Box cell(std::size_t index) const {
    const auto column = static_cast<double>(index % across);
    const auto row = static_cast<double>(index / across);
    const double left = kPageMargin + column * (cell_width + kBetween);
    const double above = top + row * (map_height + kCellCaption + kBetween) + kCellCaption;
    return {left, above, left + cell_width, above + map_height};
  }
};

Grid grid_for(const std::vector<DrawnTurn>& turns) {
  Grid out;
  out.across = std::min(kMostAcross, std::max<std::size_t>(2, turns.size()));
  const auto columns = static_cast<double>(out.across);
  out.cell_width = (kPageWidth_px - 2 * kPageMargin - (columns - 1) * kBetween) / columns;
  double widest_m = 0, highest_m = 0;
  for (const DrawnTurn& turn : turns) {
    const Box box = box_of(turn);
    widest_m = std::max(widest_m, box.width());
    highest_m = std::max(highest_m, box.height());
  }
  out.px_per_m = std::min(out.cell_width / widest_m, kMostHeight * out.cell_width / highest_m);
  out.map_height = std::ceil(out.px_per_m * highest_m);
  out.top = kPageMargin + kPageTitle;
  const std::size_t rows = (turns.size() + out.across - 1) / out.across;
  out.height_px =
      static_cast<int>(std::ceil(out.cell(rows * out.across - 1).max_y + kScaleStrip + kPageMargin));
  return out;
}

Polygon rectangle(Point a, Point b, Point c, Point d) { return {{a, b, c, d}, {}}; }

/// The land that a track works up to the border. `at` is where it ends, `along` the border.
Region track_land(Point at, const DrawnTurn& turn) {
  const double half_m = turn.width_m / 2;
  const double rise_m = half_m * turn.border.y / turn.border.x;
  const double bottom = box_of(turn).min_y;
  return {rectangle({at.x - half_m, bottom}, {at.x + half_m, bottom}, {at.x + half_m, at.y + rise_m},
                    {at.x - half_m, at.y - rise_m})};
}

/// Lines along the border, a pass apart, and a full one where the depth ends.
void draw_passes(Canvas& canvas, const DrawnTurn& turn, const Box& drawn) {
  const double reach_m = drawn.width() + drawn.height();
  const auto draw = [&](double out_m, const Stroke& stroke) {
    const Point on_line = out_m * outward_of(turn);
    line(canvas, on_line - reach_m * turn.border, on_line + reach_m * turn.border, stroke);
  };
  for (int pass = 1; (pass - 1) * turn.width_m < turn.depth_m; ++pass)
    draw(pass * turn.width_m, {kPassColour, 1, {4, 4}});
  draw(0, {kInk, 1.6});
  draw(turn.depth_m, {kReverseColour, 1.4, {9, 4}});
}

void draw_path(Canvas& canvas, const SteeredPath& path) {
  for (const SteeredStretch& stretch : path) {
    const bool forward = stretch.gear == Gear::kForward;
    const Path drawn = trace({stretch});
    if (drawn.empty()) continue;
    curve(canvas, drawn, {forward ? kForwardColour : kReverseColour, 2.4, {}});
    const Pose middle = pose_after(stretch, stretch.length_m / 2);
    const Point ahead = middle.heading.unit();
    const Point moving = forward ? ahead : Point{-ahead.x, -ahead.y};
    draw_arrow_head(canvas, canvas.view().to_page(middle.at), {moving.x, -moving.y}, 9,
                    forward ? kForwardColour : kReverseColour);
  }
}

void draw_cell(Canvas& canvas, const DrawnTurn& turn, const Box& cell, double px_per_m) {
  const Box drawn = box_of(turn);
  MapView view;
  view.centre_m = {(drawn.min_x + drawn.max_x) / 2, (drawn.min_y + drawn.max_y) / 2};
  // Level with its neighbours: all tracks begin at the bottom.
  view.centre_px = {(cell.min_x + cell.max_x) / 2, cell.max_y - px_per_m * drawn.height() / 2};
  view.px_per_m = px_per_m;
  canvas.use(view, 1);
  cairo_save(canvas.cr());
  clip_to(canvas, cell);
  const Point far_end = turn.spacing_m / turn.border.x * turn.border;
  for (const Point end : {Point{0, 0}, far_end}) {
    fill(canvas, track_land(end, turn), kLandColour);
    outline(canvas, track_land(end, turn), {kPassColour, 1, {}});
  }
  fill(canvas, turn.swept, kSweptColour);
  draw_passes(canvas, turn, drawn);
  const Point begin = turn.path.empty() ? Point{0, 0} : turn.path.front().start.at;
  const Point back = turn.path.empty() ? far_end : end_of(turn.path.back()).at;
  line(canvas, {0, drawn.min_y}, begin, {kForwardColour, 1.2, {}});
  line(canvas, back, {turn.spacing_m, drawn.min_y}, {kForwardColour, 1.2, {}});
  draw_path(canvas, turn.path);
  cairo_restore(canvas.cr());
  const TextStyle bold{kTextSize, true}, plain{kSmallTextSize, false, Align::kLeft, kFaintInk};
  draw_text(canvas, {cell.min_x, cell.min_y - kCellCaption + 14},
            fitted(canvas, turn.heading, bold, cell.width()), bold);
  draw_text(canvas, {cell.min_x, cell.min_y - kCellCaption + 34},
            fitted(canvas, turn.caption, plain, cell.width()), plain);
}

}  // namespace

void draw_turns(const std::string& title, const std::string& subtitle, const std::vector<DrawnTurn>& turns,
                const std::filesystem::path& path) {
  assert(!turns.empty() && turns.front().width_m > 0);
  const PictureFormat format = format_of(path);
  const Grid grid = grid_for(turns);
  Canvas canvas(format, kPageWidth_px, grid.height_px);
  canvas.use({}, 1);
  draw_title(canvas, {kPageMargin, kPageMargin, kPageWidth_px - kPageMargin, grid.top}, title, subtitle);
  for (std::size_t i = 0; i < turns.size(); ++i) draw_cell(canvas, turns[i], grid.cell(i), grid.px_per_m);
  const double bar_m = round_length(200 / grid.px_per_m);
  const double y = grid.height_px - kPageMargin - kScaleStrip / 2;
  stroke_line(canvas, {{kPageMargin, y}, {kPageMargin + bar_m * grid.px_per_m, y}}, {kInk, 3, {}});
  draw_text(canvas, {kPageMargin + bar_m * grid.px_per_m + 12, y},
            fmt::format(
                "{:g} m     orange: land that machine and implement pass over     blue: forward     red: in "
                "reverse     dashed red: how deep the headland has to be     dotted: headland passes",
                bar_m),
            {kSmallTextSize, false, Align::kLeft, kFaintInk});
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
